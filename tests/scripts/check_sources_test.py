import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))
import check_sources as check  # noqa: E402

SOURCE = r'''// { a bracket in a comment
#define LOOP(n) for (int i = 0; i < n; ++i) { \
    use(i); }
namespace esm {
namespace {

constexpr double values[] = {1, 2};
const char* const raw = R"x(int f() { " )x";
const int large = 1'000'000;
const auto doubled = [](int n) {
    return 2 * n;
};

struct Point {
    double x = 0, y{};
    double norm() const { return x; }
};

/// A comment above is not the function's own.
template<class Real>
Real area(const Point& p = {}, char bracket = '{') {
    if (p.x > 0) {
        return "}"[0];
    }
    return [&] { return 1; }();
}

class Team {
public:
    explicit Team(int threads) : m_threads{threads}, m_parts(3) {
        run();
    }
    bool operator()(int a) const {
        return a > 0;
    }

private:
    int m_threads, m_parts;
};

} // namespace
} // namespace esm
'''


class FunctionSizes(unittest.TestCase):
    def test_counts_from_the_type_to_the_last_bracket(self):
        self.assertEqual(check.function_sizes(SOURCE), [1, 7, 3, 3])

    def test_finds_none_where_there_is_none(self):
        self.assertEqual(check.function_sizes("enum class A { B, C };\nstruct D { int e[2] = {1, 2}; };\n"), [])


class CommentLines(unittest.TestCase):
    def test_counts_lines_with_a_comment_among_those_that_are_not_empty(self):
        self.assertEqual(check.comment_lines('/* one\n   two */\n\nint a; // three\nauto b = "// none";\n'), (3, 4))


    def test_a_folder_of_algorithms_that_explains_too_little_is_named_with_its_share(self):
        def of(comments, of_lines=100):
            return "// why\n" * comments + "int a;\n" * (of_lines - comments)

        sources = {"core/model/a.cpp": of(13), "core/model/deep/b.cpp": of(10), "core/model/c.h": of(0),
                   "core/fuzzy/d.cpp": of(12), "core/texture/layers/e.cpp": of(24), "core/texture/f.cpp": of(0),
                   "core/project/g.cpp": of(0)}
        problems = check.algorithm_comment_problems(sources)
        self.assertEqual([problem.partition(",")[0] for problem in problems],
                         ["core/model: comments are 11.5 % of its sources"])

    def test_every_folder_of_algorithms_is_one_of_the_core(self):
        self.assertLessEqual(set(check.ALGORITHM_FOLDERS), set(check.CORE_ORDER))


class Folders(unittest.TestCase):
    def test_a_ring_of_folders_is_named(self):
        edges = check.folder_edges({"core/a/x.h": '#include "core/b/y.h"\n', "core/b/y.h": '#include "core/c/z.h"\n',
                                    "core/c/z.h": '#include "core/a/x.h"\n', "core/d/w.h": '#include "core/a/x.h"\n'})
        self.assertEqual(check.cycle(edges), ["core/a", "core/b", "core/c", "core/a"])

    def test_a_folder_within_another_is_part_of_it(self):
        edges = check.folder_edges({"core/a/x.h": '#include "core/a/b/y.h"\n',
                                    "core/a/b/y.h": '#include "core/a/x.h"\n'})
        self.assertEqual(check.cycle(edges), [])

    def test_an_include_against_the_order_is_named(self):
        problems = check.layering_problems({
            "core/geometry/a.h": '#include "core/support/b.h"\n#include "core/model/c.h"\n',
            "core/model/d.h": '#include "core/render/e.h"\n', "core/render/f.h": '#include "core/model/d.h"\n',
            "widgets/view/g.h": '#include "app/editor/document/h.h"\n', "app/esmc/i.cpp": '#include "widgets/j.h"\n'})
        self.assertEqual([problem.partition(":")[0] for problem in problems],
                         ["core/geometry/a.h", "core/model/d.h", "widgets/view/g.h", "app/esmc/i.cpp"])


class Tests(unittest.TestCase):
    def test_stand_beside_what_they_test(self):
        sources = ["core/a/mesh_file.h", "tests/support/helper.h"]
        good = ["tests/core/a/mesh_file_test.cpp", "tests/core/a/mesh_file_damage_test.cpp",
                "tests/core/a/helper_test.cpp"]
        bad = ["tests/core/mesh_file_test.cpp", "tests/core/a/mesh_test.cpp"]
        self.assertEqual([problem.partition(":")[0] for problem in check.misplaced_tests(sources + good + bad)], bad)


class Lists(unittest.TestCase):
    LISTS = {".": "add_subdirectory(core)", "core": "add_library(core a.cpp geometry/mesh.cpp)",
             "tests/core": "esm_add_core_tests(a_test.cpp)\n${PROJECT_SOURCE_DIR}/tests/support/shared.cpp"}

    def test_a_source_is_listed_in_a_folder_above_it_or_by_its_whole_path(self):
        listed = ["core/a.cpp", "core/geometry/mesh.cpp", "tests/core/a_test.cpp", "tests/support/shared.cpp", "core/a.h"]
        self.assertEqual(check.unlisted_sources(listed, self.LISTS), [])

    def test_a_source_that_is_listed_nowhere_is_a_problem(self):
        lost = ["core/b.cpp", "core/geometry/a.cpp", "tests/core/test.cpp", "tests/core/other/a_test.cpp"]
        found = check.unlisted_sources(lost, self.LISTS)
        self.assertEqual([problem.partition(":")[0] for problem in found], lost)


class Sizes(unittest.TestCase):
    def test_are_told_at_the_median_of_nine_in_ten_and_at_most(self):
        self.assertEqual(check.quantiles(range(1, 12)), (6, 10, 11))

    def test_a_long_file_or_function_is_a_problem(self):
        long = "void f() {\n" + "    g();\n" * 400 + "}\n"
        self.assertEqual(len(check.file_problems({"core/a.cpp": long, "core/b.cpp": "\n", "core/a.h": long})), 1)
        self.assertTrue(check.function_problems({"core/a.cpp": long}))
        self.assertEqual(check.function_problems({"core/a.cpp": "void f() {}\n"}), [])


class Words(unittest.TestCase):
    def test_finds_words_that_mean_another_thing(self):
        for text in ("/// The photo is\n    /// thrown on the organ.\n", "What throws a photo\n", "struct HeldNode {\n", "PageBand band;\n",
                     'f(tr("one "\n   "Texel"));\n'):
            self.assertEqual(len(check.word_problems({"core/a.h": text})), 1, text)

    def test_lets_the_same_words_stand_where_they_mean_what_they_say(self):
        for text in ("/// @throws FileError where a photo cannot be read\n", "Texel texelAt(int x);\n",
                     "/// A ball is thrown aside.\n", 'f(tr("Pixel"), texel);\n'):
            self.assertEqual(check.word_problems({"core/a.h": text}), [], text)


if __name__ == "__main__":
    unittest.main(buffer=True)
