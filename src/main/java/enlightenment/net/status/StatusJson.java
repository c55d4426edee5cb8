package enlightenment.net.status;

import enlightenment.net.schedule.Snapshot;
import java.io.StringWriter;
import java.util.OptionalDouble;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** A snapshot as JSON; docs/distributed.md lists its keys. */
final class StatusJson {
    private static final JsonFactory FACTORY = new JsonFactory();

    private StatusJson() {}

    static String of(Snapshot s) {
        StringWriter text = new StringWriter();
        try (JsonGenerator out = FACTORY.createGenerator(ObjectWriteContext.empty(), text)) {
            out.writeStartObject();
            out.writeBooleanProperty("finished", s.finished());
            out.writeNumberProperty("tiles", s.tiles());
            out.writeNumberProperty("done", s.done());
            out.writeNumberProperty("leased", s.leased());
            out.writeNumberProperty("free", s.free());
            out.writeNumberProperty("auditsOpen", s.auditsOpen());
            out.writeNumberProperty("confirmed", s.confirmed());
            out.writeNumberProperty("duplicates", s.duplicates());
            out.writeNumberProperty("elapsedSeconds", s.elapsedSeconds());
            optional(out, "remainingSeconds", s.remainingSeconds());
            out.writeArrayPropertyStart("workers");
            s.workers().forEach(worker -> worker(out, worker));
            out.writeEndArray();
            out.writeArrayPropertyStart("expelled");
            s.expelled().stream().sorted().forEach(out::writeString);
            out.writeEndArray();
            out.writeArrayPropertyStart("log");
            for (Snapshot.Note note : s.notes()) {
                out.writeStartObject();
                out.writeNumberProperty("seconds", note.seconds());
                out.writeStringProperty("text", note.text());
                out.writeEndObject();
            }
            out.writeEndArray();
            out.writeEndObject();
        }
        return text + "\n";
    }

    private static void worker(JsonGenerator out, Snapshot.Worker w) {
        out.writeStartObject();
        out.writeStringProperty("name", w.name());
        out.writeNumberProperty("threads", w.threads());
        out.writeNumberProperty("connectedSeconds", w.connectedSeconds());
        out.writeNumberProperty("tiles", w.tiles());
        out.writeNumberProperty("audits", w.audits());
        out.writeNumberProperty("bytes", w.bytes());
        optional(out, "tilesPerSecond", w.tilesPerSecond());
        out.writeNumberProperty("owed", w.owed());
        out.writeNumberProperty("silentSeconds", w.silentSeconds());
        out.writeBooleanProperty("stalled", w.stalled());
        out.writeEndObject();
    }

    private static void optional(JsonGenerator out, String name, OptionalDouble value) {
        out.writeName(name);
        if (value.isPresent()) {
            out.writeNumber(value.getAsDouble());
        } else {
            out.writeNull();
        }
    }
}
