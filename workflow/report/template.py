"""HTML pages from the templates of this package."""

from collections.abc import Callable

from jinja2 import Environment, PackageLoader, StrictUndefined


def filled_template(template: str, *filters: Callable[[str], str], **context: object) -> str:
    """Return a filled template. Texts are escaped; filters are named after their functions."""
    environment = Environment(
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        loader=PackageLoader("elastomer_friction.workflow", "report"),
    )
    environment.filters |= {function.__name__: function for function in filters}
    return environment.get_template(template).render(**context)
