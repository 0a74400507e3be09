#include "app/editor/document/document.h"

#include "app/editor/document/project_command.h"
#include "app/editor/document/step_subject.h"
#include "core/exchange/fuzzy/fuzzy_file.h"

#include <QScopedValueRollback>

#include <algorithm>

namespace esm {

namespace {

using Value = std::shared_ptr<const Project>;

template<typename Part> std::uint32_t highest(const std::vector<Part>& parts) {
    return nextId(parts).number - 1;
}

/// They are always at hand, and no file holds them for nobody.
void dropShippedSystems(Project& project) {
    std::erase_if(project.spareSystems, [](const auto& system) { return isFuzzyPreset(*system); });
}

} // namespace

Document::Document(Project project, QObject* parent) : QObject(parent), m_project(std::move(project)) {
    numberParts();
    m_undoStack.setUndoLimit(mostSteps);
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, [this] {
        if (!m_isBeingReplaced) emit titleChanged();
    });
    connect(&m_undoStack, &QUndoStack::indexChanged, this, [this] {
        if (!m_isBeingReplaced) emit stepped();
    });
}

Document::~Document() {
    // The stack empties itself when it goes, which is news to nobody: the listeners may be half gone as well.
    m_undoStack.disconnect();
}

QString Document::title() const {
    if (m_path) return QString::fromStdString(m_path->filename().string());
    return m_former.title.isEmpty() ? QString::fromStdString(m_project.name) : m_former.title;
}

void Document::edit(const QString& text, const std::function<void(Project&)>& change,
                    const MergeKey& mergeKey, std::optional<RegionId> systemOf) {
    Project after = m_project;
    change(after);
    if (after.spareSystems != m_project.spareSystems) dropShippedSystems(after);
    if (after == m_project) return;
    m_undoStack.push(new ProjectCommand(*this, std::make_shared<const Project>(m_project),
                                        std::make_shared<const Project>(std::move(after)),
                                        {text, mergeKey, m_gesture, systemOf}));
}

void Document::replace(Project project, std::optional<std::filesystem::path> path, Origin origin,
                       Former former) {
    {
        const QScopedValueRollback quiet(m_isBeingReplaced, true);
        m_path = std::move(path);
        m_fileVersion.reset();
        m_former = std::move(former);
        m_project = std::move(project);
        numberParts();
        m_undoStack.clear();
        if (origin == Origin::Unsaved) m_undoStack.resetClean();
    }
    announceReplaced();
}

void Document::announceReplaced() {
    m_unfinished.clear();
    emit changed(Change::everything());
    emit replaced();
    emit titleChanged();
}

DocumentState Document::state() const {
    DocumentState state{nullptr, {}, m_undoStack.index(), file()};
    for (int i = 0; i < m_undoStack.count(); ++i) {
        const auto& command = static_cast<const ProjectCommand&>(*m_undoStack.command(i));
        if (i == 0) state.base = command.before();
        state.steps.push_back({command.step().text, command.step().systemOf, command.after()});
    }
    if (!state.base) state.base = std::make_shared<const Project>(m_project);
    return state;
}

void Document::restore(const DocumentState& state) {
    {
        const QScopedValueRollback quiet(m_isBeingReplaced, true);
        m_path = state.file.path;
        m_fileVersion = state.file.version;
        m_former = state.file.former;
        m_undoStack.clear();
        m_project = *state.base;
        m_lastRegion = highest(m_project.regions);
        m_lastLayer = highest(m_project.layers);
        Value before = state.base;
        for (const DocumentStep& step : state.steps) {
            m_undoStack.push(
                new ProjectCommand(*this, before, step.after, {step.text, {}, 0, step.systemOf}));
            before = step.after;
            m_lastRegion = std::max(m_lastRegion, highest(before->regions));
            m_lastLayer = std::max(m_lastLayer, highest(before->layers));
        }
        m_undoStack.resetClean();
        if (state.file.clean >= 0) {
            m_undoStack.setIndex(state.file.clean);
            m_undoStack.setClean();
        }
        m_undoStack.setIndex(state.index);
    }
    announceReplaced();
}

void Document::markSaved(const std::filesystem::path& path, const Project& written) {
    m_path = path;
    if (written != m_project)
        m_undoStack.resetClean();
    else
        m_undoStack.setClean();
    finishGesture();
    emit titleChanged();
}

void Document::numberParts() {
    esm::numberParts(m_project);
    m_lastRegion = static_cast<std::uint32_t>(m_project.regions.size());
    m_lastLayer = static_cast<std::uint32_t>(m_project.layers.size());
}

QString Document::stepText(int step) const {
    const auto& command = static_cast<const ProjectCommand&>(*m_undoStack.command(step));
    const QString subject = stepSubject(*command.before(), *command.after());
    return subject.isEmpty() ? command.step().text : command.step().text + QStringLiteral(" · ") + subject;
}

void Document::goTo(int stepsDone) {
    const Project before = m_project;
    const int doneBefore = m_undoStack.index();
    const bool wasClean = m_undoStack.isClean();
    {
        const QScopedValueRollback quiet(m_isBeingReplaced, true);
        m_undoStack.setIndex(stepsDone);
    }
    if (m_undoStack.index() == doneBefore) return;
    // Two steps may hold the same project.
    if (before != m_project) {
        Change change = difference(before, m_project);
        change.isOfHistory = true;
        emit changed(change);
    }
    emit stepped();
    if (m_undoStack.isClean() != wasClean) emit titleChanged();
}

void Document::take(const Project& project, const Step& step) {
    if (m_isBeingReplaced) {
        m_project = project;
        return;
    }
    Change change = difference(m_project, project);
    change.isOfHistory = step.isOfHistory;
    const auto& systemOf = step.systemOf;
    const bool isSystemEdited =
        systemOf && findPart(m_project.regions, *systemOf) && findPart(project.regions, *systemOf);
    if (isSystemEdited)
        change.system = {partOf(m_project.regions, *systemOf).system,
                         partOf(project.regions, *systemOf).system};
    m_project = project;
    emit changed(change);
}

} // namespace esm
