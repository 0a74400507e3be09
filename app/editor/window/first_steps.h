#pragma once

#include "app/editor/document/document.h"
#include "app/editor/workers/preview.h"
#include "widgets/view/view_notice.h"

#include <QTimer>

#include <functional>
#include <vector>

namespace esm {

/// Five hints for who opens the program for the first time. Each stays until what it asks for is done, or
/// until it is passed over.
class FirstSteps : public QObject {
    Q_OBJECT

public:
    FirstSteps(QWidget& view, Document& document, Preview& preview);

    void begin();
    void end();
    /// The model package, or what else simulators read, was written.
    void noteHandover() { m_isHandedOver = true; }

private:
    struct Step {
        std::function<QString(const Project&)> textFor;
        std::function<bool()> isDone; ///< asked again and again while it is shown
    };

    std::vector<Step> makeSteps();
    void show(std::size_t step);
    void look();

    Document& m_document;
    Preview& m_preview;
    ViewNotice* m_notice;
    std::vector<Step> m_steps;
    std::size_t m_step = 0;
    std::shared_ptr<const Project> m_before; ///< when the step was shown first
    int m_pulls = 0;                         ///< begun while the step is shown
    bool m_isHandedOver = false;
    QTimer m_timer;
};

} // namespace esm
