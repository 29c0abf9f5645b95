"""Pages of HTML out of the templates of this room."""

from collections.abc import Callable

from jinja2 import Environment, PackageLoader, StrictUndefined


def filled_template(template: str, *filters: Callable[[str], str], **context: object) -> str:
    """Return a template with its texts, which are escaped; filters go by their names."""
    environment = Environment(
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        loader=PackageLoader("elastomer_friction.workflow", "report"),
    )
    environment.filters |= {one.__name__: one for one in filters}
    return environment.get_template(template).render(**context)
