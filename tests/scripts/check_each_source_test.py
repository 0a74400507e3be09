import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "scripts"))
import check_each_source as check  # noqa: E402


class CheckEachSourceTest(unittest.TestCase):
    def test_finds_what_qt_writes(self):
        listed = ("widgets/a_autogen/timestamp: CUSTOM_COMMAND\nwidgets/a_autogen: phony\n"
                  "core/cmake_pch.hxx.pch: CXX_COMPILER\ncore/x.cpp.o: CXX_COMPILER\n")
        self.assertEqual(check.written_by_qt(listed), ["widgets/a_autogen/timestamp"])

    def test_precompiles_by_a_headers_own_command(self):
        header = {"file": "core/CMakeFiles/esm.dir/cmake_pch.hxx.cxx", "command": "/usr/bin/ccache c++ -c a -o a.pch"}
        self.assertEqual(check.command_of(header), ["c++", "-c", "a", "-o", "a.pch"])

    def test_complains_of_a_source_that_lacks_an_include_and_makes_no_object(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in (("good.cpp", "int f() { return 1; }\n"), ("bad.cpp", "std::string g();\n")):
                (Path(folder) / name).write_text(text)
            entry = lambda name: {"directory": folder, "file": name, "command": f"/usr/bin/ccache c++ -c {name} -o x.o"}
            self.assertEqual(check.complaint_of(entry("good.cpp")), "")
            self.assertIn("bad.cpp", check.complaint_of(entry("bad.cpp")))
            self.assertFalse((Path(folder) / "x.o").exists())


if __name__ == "__main__":
    unittest.main()
