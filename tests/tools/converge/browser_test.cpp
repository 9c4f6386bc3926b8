/// The page of brandung converge in a real browser, where one is installed.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "tests/tools/browser.h"
#include "tests/tools/program.h"
#include "tools/converge/report.h"

namespace brandung {
namespace {

/// Errors are factor / samples, and a tenth more and less, at 1, 2, 4 and 8 samples of a second each; its name is no good HTML.
Series inverse_series(const std::string &name, double factor) {
    Series series{name, {}};
    for (std::size_t rung = 0; rung < 4; ++rung)
        for (const double part : {0.9, 1.1}) {
            const double samples = double(1 << rung), error = factor * part / samples;
            series.runs.push_back({rung, 1, samples, samples, {{"mse", error}, {"relmse", error}, {"mape", error}, {"flip", error}}});
        }
    series.way = Way{name, {{"scene_hash", "0123"}, {"sampler", name}, {"max_depth", "5"}}, {{"depth limit", "ended 7 rays"}}};
    return series;
}

Convergence example() {
    Convergence convergence{.subject = {"a.json", "0123", "some device", "brandung 1", "64 spp", 8, 6, 0.002, {"film.filter=tent"}},
                            .series = {inverse_series("first <b>", 0.14), inverse_series("second", 0.1414)},
                            .summaries = {},
                            .warnings = {"first: beware"},
                            .runs_done = 16,
                            .runs_total = 16};
    const auto targets = round_targets(convergence.series);
    for (const Series &series : convergence.series) convergence.summaries.push_back(summarize(series, targets, 0.002));
    return convergence;
}

std::size_t count(const std::string &text, const std::string &pattern) {
    const std::regex regex(pattern);
    return static_cast<std::size_t>(std::distance(std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()));
}

/// y of every element with that start.
std::vector<double> places(const std::string &page, const std::string &start) {
    std::vector<double> all;
    const std::regex regex(start + "[^>]* y=\"([-0-9.]+)\"");
    for (std::sregex_iterator at(page.begin(), page.end(), regex), end; at != end; ++at) all.push_back(std::stod((*at)[1]));
    return all;
}

/// The last rung's mean, 0.14 / 8, is less than ten times the reference's noise, which makes it hollow and leaves three rungs to fit a line to.
TEST(ConvergencePage, DrawsEverySeriesInABrowser) {
    if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
    const TemporaryFolder folder;
    const std::string page =
        page_after("file://" + folder.write("page.html", convergence_page(example())) + "#mse,samples", 500, folder.path("profile"));
    EXPECT_EQ(text_of(page, "title"), "a.json");
    EXPECT_NE(text_of(page, "subject").find("8 × 6 pixels on some device; reference: 64 spp, whose own noise is 0.002 (relMSE)"), std::string::npos)
        << text_of(page, "subject");
    EXPECT_NE(page.find("<div>first: beware</div>"), std::string::npos);
    EXPECT_EQ(count(page, "<circle[^>]*fill=\"#fff\""), 2u) << "near the reference's noise";
    EXPECT_EQ(count(page, "<circle"), 8u);
    EXPECT_EQ(count(page, "<line class=\"fit\""), 2u);
    EXPECT_NE(page.find("first &lt;b&gt; (−1.00)</text>"), std::string::npos) << "a label with its slope";
    EXPECT_NE(page.find(">samples per pixel</text>"), std::string::npos) << "as the address asks for";
    EXPECT_NE(page.find(">mse</text>"), std::string::npos);
    const std::vector<double> labels = places(page, "<text class=\"label\"");
    ASSERT_EQ(labels.size(), 2u);
    EXPECT_GE(std::abs(labels[1] - labels[0]), 13) << "two lines of text";
    for (const char *row :
         {"<tr><td>program</td><td>brandung 1</td></tr>", "<tr><td>--set</td><td>film.filter=tent</td></tr>", "<tr><td>max_depth</td><td>5</td></tr>",
          "<tr><td>sampler</td><td>first &lt;b&gt;: first &lt;b&gt;; second: second</td></tr>",
          "<td>second is biased by</td><td>depth limit: ended 7 rays</td>"})
        EXPECT_NE(page.find(row), std::string::npos) << row;
    // 0.14 / n is 0.1 after 1.4 samples, 0.03 after 4.67, beyond the third rung, the last that is not near the reference's noise.
    EXPECT_NE(page.find("<tr><td>first &lt;b&gt;</td><td>1.4</td><td>&gt; 4</td></tr>"), std::string::npos)
        << page.substr(page.find("id=\"targets\""), 500);
    for (const char *fault : {"NaN", "undefined", "Infinity", "[object"}) {
        const std::string body = page.substr(page.find("<svg"));
        EXPECT_EQ(body.substr(0, body.find("<script>")).find(fault), std::string::npos) << fault;
    }
}

}  // namespace
}  // namespace brandung
