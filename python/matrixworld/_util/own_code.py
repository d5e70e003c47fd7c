"""What stands for code of your own among sections: its name and its settings."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, ClassVar

from matrixworld._util import plugins
from matrixworld._util.checks import shown
from matrixworld._util.sections import (
    OWN,
    Section,
    SettingError,
    build,
    section,
    setting,
    settings_of,
)


@section()
class OwnCode(Section):
    """Base of what stands for a section of your own: its name, and its settings.

    Only `load` imports, when a run is made or goes on.
    """

    kind: ClassVar[str] = OWN
    base: ClassVar[type]  # what it has to be derived from

    code: str = setting("", "module:object")
    settings: Mapping[str, Any] = setting({}, "its settings: numbers, text, true or false")

    @classmethod
    def named(cls, own: Any) -> dict[str, Any]:
        """Return the fields that stand for a class of your own, or for an object of one."""
        if isinstance(own, type):
            return {"code": plugins.name_of(own)}
        values = {item.name: getattr(own, item.name) for item in settings_of(type(own))}
        settings = {name: value for name, value in values.items() if value is not None}
        return {"code": plugins.name_of(type(own)), "settings": settings}

    def check(self) -> None:
        """Raise ValueError unless a name is given."""
        if not plugins.PATH.fullmatch(self.code):
            raise SettingError("code", "module:object", shown(self.code))

    def load(self, usual: Callable[[Any], Mapping[str, Any]] | None = None) -> Any:
        """Return the section of your own; ValueError if it refuses its settings, or PluginError.

        `usual` returns, of its class, defaults of fields that it inherits from the package.
        """
        cls = plugins.imported(self.code)
        # Before it is called: the files of a stranger's run must not name any function at all.
        if not (isinstance(cls, type) and issubclass(cls, self.base)):
            expected = f"a class derived from {self.base.__name__}"
            raise ValueError(f"{self.code}: expected {expected}, got {shown(cls)}")
        defaults = usual(cls) if usual else {}
        inherited = {name: v for name, v in defaults.items() if _declared_here(cls, name)}
        try:
            return build(cls, {**inherited, **self.settings}, cls)
        except (TypeError, ValueError) as error:
            raise ValueError(f"{self.code}: {error}") from error
        except (Exception, SystemExit) as error:
            raise plugins.PluginError(f"{self.code}: {type(error).__name__}: {error}") from error


def _declared_here(cls: type, name: str) -> bool:
    """Return whether the package, and no class of the user, declares a field of a class."""
    for ancestor in cls.__mro__:
        if name in vars(ancestor).get("__annotations__", {}):
            return ancestor.__module__.startswith("matrixworld.")
    return False
