// A page beside the point file of each finding of a campaign, which shows the points and what is wrong with them.
//
// Guarantees: making a page takes a process of its own. If it crashes or takes too long, the page is not there, and
// nothing else happens. A page appears whole or not at all.
#pragma once

#include "fuzz/campaign/campaign.h"
#include "fuzz/commands/layer.h"

namespace flowcert::commands {

// Findings that end their process have no page, because its page would end as well. A campaign that was stopped gets
// its pages, too.
void write_finding_pages(const fuzz::Campaign& campaign);

}  // namespace flowcert::commands
