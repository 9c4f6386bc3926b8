/// The page of a preview in a real browser, where one is installed.
#include <gtest/gtest.h>
#include <httplib.h>

#include <csignal>
#include <regex>

#include "tests/tools/browser.h"
#include "tests/tools/program.h"

namespace {

/// "12&nbsp;%" as 12; -1 if there is no number.
double number_of(const std::string &text) {
    const char *const begin = text.c_str();
    char *end = nullptr;
    const double number = std::strtod(begin, &end);
    return end == begin ? -1 : number;
}

TEST(Browser, ShowsARenderThatGrows) {
    if (!has_browser()) GTEST_SKIP() << "chromium is not installed";
    const TemporaryFolder folder;
    std::string early, late;
    const auto look = [&](const std::string &err) {
        const std::size_t place = err.find("http://"), end = err.find("/\n", place);
        if (end == err.npos) return 0;
        const std::string url = err.substr(place, end - place);
        const auto state = httplib::Client(url).Get("/state.json");
        if (!state || state->body.find("\"phase\":\"rendering\"") == std::string::npos) return 0;  // kernels are compiled first
        if (!early.empty() && state->body.find("\"noise\":null") != std::string::npos) return 0;   // noise is estimated now and then
        std::string &page = early.empty() ? early : late;
        page = page_after(url, 2500, folder.path("profile"));
        return late.empty() ? 0 : SIGINT;
    };
    // More samples than can be rendered before the browser has looked twice; one thread leaves it the other.
    run_program({"render", BRANDUNG_SOURCE_DIR "/scene/examples/whitted_1980.json", "--spp", "100000", "--threads", "1", "--quiet", "--preview",
                 "web:0", "-o", folder.path("out.png")},
                {.seconds = 200, .signal_when = look});

    for (const std::string &page : {early, late}) {
        EXPECT_EQ(text_of(page, "phase"), "rendering");
        EXPECT_NE(text_of(page, "scene").find("whitted_1980.json"), std::string::npos);
        EXPECT_NE(page.find("whitted_1980.json – brandung</title>"), std::string::npos);
        EXPECT_NE(text_of(page, "about").find("640 × 480 pixels · 100000 samples per pixel"), std::string::npos) << text_of(page, "about");
        EXPECT_TRUE(std::regex_search(page, std::regex("<img id=\"picture\"[^>]*src=\"blob:[^>]*>"))) << "the picture has been loaded";
        EXPECT_FALSE(std::regex_search(page, std::regex("<img id=\"picture\"[^>]*hidden"))) << "and is shown";
        EXPECT_TRUE(std::regex_search(page, std::regex("<canvas id=\"queues\"[^>]*aria-label=\"Most rays waiting[^\"]*generation 1, [1-9]")));
        for (const char *row : {"refracted", "trace_shadow_rays", "shade_whitted"})
            EXPECT_NE(page.find(">" + std::string(row) + "</th>"), std::string::npos) << row;
    }
    EXPECT_GT(number_of(text_of(early, "seconds")), 0);
    std::smatch noise;
    const std::string noise_text = text_of(late, "noise");
    ASSERT_TRUE(std::regex_match(noise_text, noise, std::regex("([-0-9.e]+) \\(([-0-9.e]+)–([-0-9.e]+)\\)"))) << noise_text;
    EXPECT_GT(std::stod(noise[1]), std::stod(noise[2]));
    EXPECT_LT(std::stod(noise[1]), std::stod(noise[3]));
    for (const char *id : {"samples-speed", "rays-speed"}) EXPECT_GT(number_of(text_of(late, id)), 0) << id << ": " << text_of(late, id);
    const auto value_of_bar = [](const std::string &page) {
        std::smatch found;
        return std::regex_search(page, found, std::regex("<progress[^>]*value=\"([^\"]*)\"")) ? std::stod(found[1]) : -1;
    };
    EXPECT_GT(value_of_bar(early), 0);
    EXPECT_GT(value_of_bar(late), value_of_bar(early));
    EXPECT_LT(value_of_bar(late), 1);
}

}  // namespace
