#pragma once

#include "core/model/project.h"

#include <QObject>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace esm {

/// Composes the photos into the atlas on a thread of its own. A project that comes while it works waits; only
/// the latest is kept. Another mesh or atlas stops the work at once.
class TextureComposer : public QObject {
    Q_OBJECT

public:
    using Pages = std::shared_ptr<const std::vector<Image>>;

    explicit TextureComposer(QObject* parent = nullptr);
    ~TextureComposer() override;

    void compose(const Project& project);

    Pages pages() const;                        ///< null while nothing is composed
    std::shared_ptr<const Atlas> atlas() const; ///< the one the pages belong to
    double milliseconds() const;                ///< the last composition took
    std::string failure() const;                ///< why it could not be composed; empty when all is well

signals:
    void composed();

private:
    void work();
    void composeOnce(const Project& project);

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::optional<Project> m_waiting;
    bool m_stop = false;
    std::shared_ptr<const Atlas> m_atlas;
    Pages m_pages;
    double m_milliseconds = 0;
    std::string m_failure;
    std::thread m_thread;
};

} // namespace esm
