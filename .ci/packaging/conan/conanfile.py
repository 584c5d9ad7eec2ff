# SPDX-License-Identifier: MIT
"""The libraries of the checkout that this recipe lies in, for Conan 2."""
import pathlib

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rm, rmdir


class Occlude(ConanFile):
    name = "occlude"
    version = "0.1.0"
    description = "Occlusion culling with shadow frusta, certified"
    license = "MIT"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    # Public headers include GLM. Highway is linked by programs, because the libraries are static.
    requires = "glm/1.0.1", "highway/1.2.0"

    def export_sources(self):
        root = pathlib.Path(self.recipe_folder).parents[2]
        for pattern in "CMakeLists.txt", "*.md", "LICENSE", "cmake/*", "docs/*", "kernel/*", "culler/*", "render/images/*":
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 20)

    def generate(self):
        dependencies = CMakeDeps(self)
        dependencies.set_property("highway", "cmake_file_name", "hwy")
        dependencies.set_property("highway::hwy", "cmake_target_name", "hwy::hwy")
        dependencies.generate()
        toolchain = CMakeToolchain(self)
        for option in "OCCLUDE_TOOLS", "OCCLUDE_TESTS", "OCCLUDE_PYTHON":
            toolchain.cache_variables[option] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, pathlib.Path(self.package_folder) / "licenses")
        # Conan makes its own descriptions, and what of the C interface is shared is called as what is static.
        libraries = pathlib.Path(self.package_folder) / "lib"
        rmdir(self, libraries / "cmake")
        rmdir(self, libraries / "pkgconfig")
        rm(self, "libocclude_c.so*", libraries)

    def package_info(self):
        self.cpp_info.components["kernel"].libs = ["occlude_kernel"]
        self.cpp_info.components["kernel"].requires = ["highway::hwy"]
        self.cpp_info.components["culler"].libs = ["occlude_culler"]
        self.cpp_info.components["culler"].requires = ["kernel", "glm::glm"]
        self.cpp_info.components["c"].libs = ["occlude_c"]
        self.cpp_info.components["c"].requires = ["culler"]
        if self.settings.os in ("Linux", "FreeBSD"):
            self.cpp_info.components["culler"].system_libs = ["pthread", "m"]
