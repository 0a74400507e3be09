#include "core/exchange/package/xmp_packet.h"

namespace esm {

namespace {

/// XMP has a text for each language; nobody said which this one is in.
nlohmann::ordered_json inAnyLanguage(const std::string& text) {
    return {{"@type", "rdf:Alt"}, {"rdf:_1", {{"@language", "x-default"}, {"@value", text}}}};
}

} // namespace

nlohmann::ordered_json xmpPacket(const Provenance& provenance) {
    const auto& [title, author, date, licence] = provenance.authorship;
    nlohmann::ordered_json packet{{"@context",
                                   {{"dc", "http://purl.org/dc/elements/1.1/"},
                                    {"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"},
                                    {"xmp", "http://ns.adobe.com/xap/1.0/"}}},
                                  {"dc:format", "model/gltf-binary"},
                                  {"xmp:CreatorTool", provenance.program}};
    if (!title.empty()) packet["dc:title"] = inAnyLanguage(title);
    if (!author.empty()) packet["dc:creator"]["@list"] = {author};
    if (!date.empty()) packet["xmp:CreateDate"] = date;
    if (!licence.empty()) packet["dc:rights"] = inAnyLanguage(licence);
    if (provenance.source) packet["dc:source"] = provenance.source->file;
    return packet;
}

} // namespace esm
