#include "experiments/core/table.hpp"

#include <gtest/gtest.h>

#include "shapes/base/contracts.hpp"

namespace gridstep {
namespace {

const Table example{"Errors of κ",
                    {{"estimator", Align::left}, {"slope"}, {"±"}},
                    {{"ii_full", "0.333", "0.01"}, {"a, \"b\"", "−1", "√2"}}};

TEST(Table, IsAlignedInATerminal) {
  EXPECT_EQ(to_text(example),
            "Errors of κ\n"
            "estimator  slope     ±\n"
            "---------  -----  ----\n"
            "ii_full    0.333  0.01\n"
            "a, \"b\"        −1    √2\n");
  EXPECT_EQ(to_text({"", {{"a", Align::left}}, {{"long"}, {""}}}), "a\n----\nlong\n\n");
}

TEST(Table, QuotesCsv) {
  EXPECT_EQ(to_csv(example), "estimator,slope,±\nii_full,0.333,0.01\n\"a, \"\"b\"\"\",−1,√2\n");
  EXPECT_EQ(to_csv({"", {{"a"}}, {{"x\ny"}}}), "a\n\"x\ny\"\n");
}

TEST(Table, EscapesLatex) {
  EXPECT_EQ(to_latex(example),
            "\\begin{table}\n\\centering\n\\caption{Errors of $\\kappa$}\n\\begin{tabular}{lrr}\n\\toprule\n"
            "estimator & slope & $\\pm$ \\\\\n\\midrule\n"
            "ii\\_full & 0.333 & 0.01 \\\\\n"
            "a, \"b\" & $-$1 & $\\surd$2 \\\\\n"
            "\\bottomrule\n\\end{tabular}\n\\end{table}\n");
  const std::string hard = to_latex({"", {{"a"}}, {{"\\{}$&#^_~%é"}, {"[0.1, 0.2]"}}});
  EXPECT_NE(hard.find("\\textbackslash{}\\{\\}\\$\\&\\#\\textasciicircum{}\\_\\textasciitilde{}\\%é"),
            std::string::npos);
  EXPECT_NE(hard.find("{}[0.1, 0.2]"), std::string::npos);
  EXPECT_EQ(hard.find("\\caption"), std::string::npos);
}

TEST(Table, RefusesARowOfAnotherLength) {
  const Table bad{"", {{"a"}, {"b"}}, {{"1"}}};
  EXPECT_THROW(to_text(bad), ContractViolation);
  EXPECT_THROW(to_csv(bad), ContractViolation);
  EXPECT_THROW(to_latex(bad), ContractViolation);
}

TEST(Table, TooWideForTheTerminalBecomesBlocks) {
  const Table table{"Slopes", {{"shape", Align::left}, {"κ"}}, {{"ellipse", "0.35"}, {"flower", "0.25"}}};
  EXPECT_EQ(to_text(table, 13), to_text(table));
  EXPECT_EQ(to_text(table, 12), "Slopes\n\nshape  ellipse\nκ      0.35\n\nshape  flower\nκ      0.25\n");
}

}  // namespace
}  // namespace gridstep
