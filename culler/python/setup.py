# SPDX-License-Identifier: MIT
"""Makes the wheel: CMake builds what is C++, without the oracle (README.md, Licences). All that is made on the way lies in
build/wheel of the project."""
import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = pathlib.Path(__file__).resolve().parents[2]
BUILD = PROJECT / "build" / "wheel"


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "OCCLUDE_TOOLS": "OFF",
            "OCCLUDE_TESTS": "OFF",
            "OCCLUDE_NUMPY_PYTHON": sys.executable,
        }
        defined = [f"-D{name}={value}" for name, value in options.items()]
        folder = pathlib.Path(self.build_temp)
        subprocess.run(["cmake", "-S", PROJECT, "-B", folder, *defined], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "python", "--parallel", str(os.cpu_count())], check=True)
        made = pathlib.Path(self.get_ext_fullpath(extension.name))
        self.mkpath(str(made.parent))
        self.copy_file(str(folder / "python" / "occlude" / made.name), str(made))
        self.copy_file(str(PROJECT / "LICENSE"), str(made.parent))


BUILD.mkdir(parents=True, exist_ok=True)
setup(
    version=re.search(r"project\(occlude VERSION ([\d.]+)", (PROJECT / "CMakeLists.txt").read_text())[1],
    ext_modules=[Extension("occlude._occlude", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={"build": {"build_base": str(BUILD)}, "egg_info": {"egg_base": str(BUILD)}},
)
