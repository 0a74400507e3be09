#include "core/exchange/fuzzy/fcl_words.h"

#include "core/fuzzy/keywords.h"

#include <algorithm>

namespace esm {

namespace {

constexpr std::string_view fclMarks = "(),;:=|";

/// fuzzylite takes # and %, jFuzzyLogic // and /* */.
const std::vector<RemarkForm>& fclRemarkForms() {
    static const std::vector<RemarkForm> forms{
        {"(*", "*)"}, {"/*", "*/"}, {"//", "\n"}, {"#", "\n"}, {"%", "\n"}};
    return forms;
}

} // namespace

FclWords::FclWords(const std::string& text) {
    SourceCode source = withoutRemarks(text, fclRemarkForms());
    m_words = textWords(source.code, {}, fclMarks);
    m_words.push_back({"", source.end});
    m_remarks = std::move(source.remarks);
}

bool FclWords::is(const char* keyword) const {
    return isKeyword(word().text, keyword);
}

bool FclWords::isMark() const {
    return !isAtEnd() && fclMarks.find(word().text) != fclMarks.npos;
}

bool FclWords::accept(const char* keyword) {
    if (!is(keyword)) return false;
    ++m_next;
    return true;
}

void FclWords::expect(const char* keyword) {
    if (!accept(keyword)) fail(keyword);
}

void FclWords::fail(const std::string& expected) const {
    failAt(word().place, "expected " + expected +
                             (isAtEnd() ? ", but the file ends" : ", but found \"" + word().text + "\""));
}

TextWord FclWords::take(const char* expected) {
    if (isAtEnd() || isMark()) fail(expected);
    return skip();
}

TextWord FclWords::named() {
    expect(":");
    TextWord name = take("a name");
    expect(";");
    return name;
}

std::vector<TextWord> FclWords::statement() {
    std::vector<TextWord> words;
    while (!accept(";")) {
        if (isAtEnd() || inSmallLetters(word().text).compare(0, 4, "end_") == 0) fail("\";\"");
        words.push_back(skip());
    }
    return words;
}

std::string FclWords::restOfLine(const std::vector<const char*>& keywords) {
    const std::size_t line = m_next > 0 ? m_words[m_next - 1].place.line : 1;
    std::string text;
    const auto isWord = [&](const char* keyword) { return is(keyword); };
    while (!isAtEnd() && word().place.line == line && std::none_of(keywords.begin(), keywords.end(), isWord))
        text += (text.empty() ? "" : " ") + skip().text;
    return text;
}

std::vector<TextRemark> FclWords::remarksBeside(const TextPlace& begin) {
    const std::size_t line = m_words[m_next - 1].place.line;
    std::vector<TextRemark> remarks;
    for (; m_nextRemark < m_remarks.size(); ++m_nextRemark) {
        const TextRemark& remark = m_remarks[m_nextRemark];
        if (!isBefore(remark.place, word().place)) break;
        if (!isBefore(remark.place, begin) && remark.place.line <= line) remarks.push_back(remark);
    }
    return remarks;
}

} // namespace esm
