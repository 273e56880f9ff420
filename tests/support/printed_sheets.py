"""What of a driver's sheet a browser finds cut off, and how its print counts pages."""

PAGES = rb"/Type\s*/Page[^s]"

FAULTS = """() => [...document.querySelectorAll('.sheet')].flatMap((sheet) => {
  const page = sheet.getBoundingClientRect();
  const out = [...sheet.querySelectorAll(':scope > *, .step, .head, .without, .face, dd, h1, td')]
    .filter((one) => {
      const box = one.getBoundingClientRect();
      return box.bottom > page.bottom + 0.5 || box.right > page.right + 0.5
        || one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0;
    });
  const texts = [...sheet.querySelectorAll('.strip text')].filter((text) => {
    const box = text.getBoundingClientRect();
    return box.left < page.left - 1 || box.right > page.right + 1;
  });
  return [...out, ...texts].map((one) =>
    `${sheet.id}: ${one.tagName} ${one.className} ${one.textContent.slice(0, 40)}`);
})"""
