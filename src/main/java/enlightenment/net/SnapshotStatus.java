package enlightenment.net;

import enlightenment.net.schedule.Snapshot;
import enlightenment.status.State;
import enlightenment.status.Status;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The figures of a server on its status page; docs/guide/distributed.md lists the names of its figures. */
final class SnapshotStatus {
    private SnapshotStatus() {}

    static Status of(Snapshot s) {
        Map<String, Object> figures = new LinkedHashMap<>();
        figures.put("tiles", s.tiles());
        figures.put("leased", s.leased());
        figures.put("free", s.free());
        figures.put("auditsOpen", s.auditsOpen());
        figures.put("confirmed", s.confirmed());
        figures.put("duplicates", s.duplicates());
        figures.put("workers", s.workers().stream().map(SnapshotStatus::worker).toList());
        figures.put("expelled", s.expelled().stream().sorted().toList());
        List<Status.Note> notes = s.notes().stream()
                .map(note -> new Status.Note(note.seconds(), note.text()))
                .toList();
        return new Status(
                "",
                s.finished() ? State.FINISHED : State.RENDERING,
                s.done(),
                s.tiles(),
                "tiles",
                s.elapsedSeconds(),
                s.remainingSeconds(),
                // Another picture with each tile.
                1L + s.done(),
                figures,
                notes);
    }

    private static Map<String, Object> worker(Snapshot.Worker w) {
        Map<String, Object> figures = new LinkedHashMap<>();
        figures.put("name", w.name());
        figures.put("threads", w.threads());
        figures.put("connectedSeconds", w.connectedSeconds());
        figures.put("tiles", w.tiles());
        figures.put("audits", w.audits());
        figures.put("bytes", w.bytes());
        figures.put("tilesPerSecond", w.tilesPerSecond());
        figures.put("owed", w.owed());
        figures.put("silentSeconds", w.silentSeconds());
        figures.put("stalled", w.stalled());
        return figures;
    }
}
