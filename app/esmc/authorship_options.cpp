#include "app/esmc/authorship_options.h"

#include "app/esmc/commands.h"

namespace esm {

namespace {

void declareStatement(CLI::App& command, const std::string& name, std::string& statement,
                      const std::string& purpose) {
    command.add_option(name, statement, purpose)->check([name](const std::string& given) {
        return given.empty() ? name + ": is empty; leave it out where there is nothing to say" : "";
    });
}

} // namespace

void declareAuthorship(CLI::App& command, Authorship& authorship) {
    declareStatement(command, "--title", authorship.title, "What the organ is called in catalogues");
    declareStatement(command, "--author", authorship.author, "Who made it");
    declareStatement(command, "--date", authorship.date,
                     "When it was made: a year, a month or a day, as 2026-05-17. No date is written without");
    declareStatement(command, "--licence", authorship.licence, "What others may do with it");
}

std::string givenAuthorship(const Authorship& authorship) {
    std::string given;
    forEachField(fieldsOf<Authorship>, [&](const auto& field) {
        if (given.empty() && !(authorship.*field.member).empty()) given = std::string("--") + field.key;
    });
    return given;
}

void checkAuthorship(const Authorship& authorship) {
    forEachField(fieldsOf<Authorship>, [&](const auto& field) {
        Authorship alone;
        alone.*field.member = authorship.*field.member;
        const std::vector<std::string> problems = validate(alone);
        if (!problems.empty()) throw UsageError(std::string("--") + field.key + ": " + problems.front());
    });
}

} // namespace esm
