"""Where text meets markup: fragments, figures and names as people read them."""
