"""The page as a `folium.Map`: folium creates the map object, all else is stored text.

folium renders every string it is given as a Jinja template, so it is given constants only. Our
content is put in by a figure that joins finished texts and renders none of them.
"""

from __future__ import annotations

from html import escape
from typing import Any

import folium
from branca.element import Figure
from folium.template import Template

from .page_parts import PageParts

__all__ = ["PlanMap"]


class PageFigure(Figure):
    """A figure that lays out the report page instead of folium's own.

    Parameters
    ----------
    parts : PageParts
        What the page is put together from.
    """

    def __init__(self, parts: PageParts) -> None:
        super().__init__()
        self._id = "page"
        self._parts = parts
        # branca's meta element goes: the policy must be the first thing in the head.
        self.header._children.clear()

    def render(self, **kwargs: Any) -> str:
        """Return the page; texts of the plan never pass through Jinja.

        Parameters
        ----------
        **kwargs : dict
            As folium hands them on.

        Returns
        -------
        str
            HTML.
        """
        for child in self._children.values():
            child.render(**kwargs)
        (plan_map,) = (child for child in self._children.values() if isinstance(child, PlanMap))
        return self._parts.html(
            plan_map.get_name(),
            header=self.header.render(**kwargs),
            extra=self.html.render(**kwargs),
            script=self.script.render(**kwargs),
        )

    def _repr_html_(self, **kwargs: Any) -> str:
        # branca's own frame has no title, which readers of screens say, and attributes in quotes.
        title, page = escape(self._parts.document.title), escape(self.render(**kwargs))
        width, height = self.width, self.height or "640px"
        return (
            f'<iframe title="{title}" srcdoc="{page}" width="{width}" height="{height}" '
            'style="border: 0 !important" allowfullscreen></iframe>'
        )


class PlanMap(folium.Map):
    """A map without any file from elsewhere, with element ids that never change.

    Parameters
    ----------
    parts : PageParts
        What the page is put together from.
    """

    default_js: list[tuple[str, str]] = []  # noqa: RUF012 (folium's own name and type)
    default_css: list[tuple[str, str]] = []  # noqa: RUF012 (likewise)

    # Of folium's template only the script stays: its styles and its viewport, which forbids
    # zooming, are not wanted, and the page has the element already.
    _template = Template(
        """
        {% macro script(this, kwargs) %}
        var {{ this.get_name() }} = L.map(
            {{ this.get_name()|tojson }},
            {center: {{ this.location|tojson }}, ...{{ this.options|tojavascript }}}
        );
        {% endmacro %}
        """
    )

    def __init__(self, parts: PageParts) -> None:
        super().__init__(
            location=(0, 0),
            tiles=None,
            zoom_control=False,
            attribution_control=False,
            zoom_snap=0.25,
            zoom_delta=1,
            wheel_px_per_zoom_level=90,
            world_copy_jump=False,
            # The page watches its frame itself, which may change without the window.
            track_resize=False,
        )
        self._id = "plan"
        figure = PageFigure(parts)
        # Map.__init__ made a figure of its own; ours takes its place.
        del self._parent
        figure.add_child(self)
