"""`make wheel`: a wheel with machine code for x86-64-v3; its name contains the compiler.

    python -m tests.tools.wheel

It installs everywhere. With another Python, numba or processor, kernels are compiled as without
the machine code.
"""

import base64
import hashlib
import os
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from elastomer_friction.kernels.compile.cache import CACHE_NAME, COMPILER, V3

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = "elastomer_friction/kernels/compile/shipped"
COMPILE = """
from elastomer_friction.kernels import SCHEMES, Quantities, loading
for scheme in SCHEMES:
    loading.load(scheme, Quantities())
"""


def machine_code(wheel: Path, folder: Path) -> dict[str, bytes]:
    """Return the files of machine code for a velocity step, by name."""
    subprocess.run([*PIP, "install", "--no-deps", "--target", folder / "site", wheel], check=True)
    how = {"NUMBA_CPU_NAME": V3, "NUMBA_CPU_FEATURES": "", "NUMBA_CACHE_DIR": str(folder / "code")}
    environment = os.environ | how | {"PYTHONPATH": str(folder / "site")}
    command = [sys.executable, "-c", COMPILE]
    subprocess.run(command, check=True, env=environment, cwd=folder)
    made = folder / "code" / CACHE_NAME  # contains a folder named by the hash of the sources
    files = sorted(made.glob(f"*/{COMPILER}/*.bin"))
    return {f"{SHIPPED}/{path.relative_to(made).as_posix()}": path.read_bytes() for path in files}


def add(wheel: Path, files: dict[str, bytes], target: Path) -> None:
    """Write a copy of a wheel with additional files."""
    with zipfile.ZipFile(wheel) as old, zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as new:
        for name in old.namelist():
            content = old.read(name)
            if name.endswith(".dist-info/RECORD"):
                content += "".join(map(row, files, files.values())).encode()
            new.writestr(name, content)
        for name, content in files.items():
            new.writestr(name, content)


def row(name: str, content: bytes) -> str:
    """Return the row of a file in RECORD."""
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


PIP = (sys.executable, "-m", "pip", "-q", "--disable-pip-version-check")


def main() -> None:
    """Build the wheel in dist/ and print its size."""
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        subprocess.run([*PIP, "wheel", "--no-deps", "-w", folder, ROOT], check=True)
        (plain,) = folder.glob("*.whl")
        files = machine_code(plain, folder)
        name, version, *tags = plain.name.split("-")
        code = f"1{COMPILER}"
        target = ROOT / "dist" / "-".join([name, version, code, *tags])
        target.parent.mkdir(exist_ok=True)
        add(plain, files, target)
    print(f"{target}: {sum(map(len, files.values())) / 1e6:.1f} MB of machine code for {V3}")


if __name__ == "__main__":
    main()
