#include "app/esmc/context.h"

#include <cmath>
#include <iostream>
#include <unistd.h>

namespace esm {

namespace {

/// A percentage on one line that goes away with the last copy of the progress.
class ProgressLine {
public:
    explicit ProgressLine(std::string label) : m_label(std::move(label)) {}
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;
    ~ProgressLine() {
        if (!m_shown.empty()) std::cerr << "\r\033[K" << std::flush;
    }

    void show(double fraction) {
        const std::string shown = ' ' + std::to_string(std::lround(100 * fraction)) + " %";
        if (shown == m_shown) return;
        m_shown = shown;
        std::cerr << '\r' << m_label << m_shown << std::flush;
    }

private:
    std::string m_label, m_shown;
};

} // namespace

Progress progressOf(const Context& context, const std::string& label) {
    const Interruption& interruption = context.interruption;
    if (::isatty(STDERR_FILENO) == 0) return [&interruption](double) { return !interruption.requested(); };
    return [&interruption, line = std::make_shared<ProgressLine>(label)](double fraction) {
        line->show(fraction);
        return !interruption.requested();
    };
}

void refuseEmptyValues(CLI::App& command) {
    const CLI::Validator check(
        [](const std::string& text) -> std::string { return text.empty() ? "must not be empty" : ""; }, "");
    for (CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0) option->check(check);
}

} // namespace esm
