package enlightenment.status;

import java.io.StringWriter;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** A status as JSON; docs/guide/watching.md lists the keys of all renders, docs/guide/distributed.md those of servers. */
final class StatusJson {
    private static final JsonFactory FACTORY = new JsonFactory();

    private StatusJson() {}

    static String of(Status s) {
        StringWriter text = new StringWriter();
        try (JsonGenerator out = FACTORY.createGenerator(ObjectWriteContext.empty(), text)) {
            out.writeStartObject();
            out.writeStringProperty("title", s.title());
            out.writeStringProperty("state", s.state().word());
            out.writeBooleanProperty("finished", s.state() == State.FINISHED);
            out.writeNumberProperty("done", s.done());
            out.writeNumberProperty("total", s.total());
            out.writeStringProperty("unit", s.unit());
            out.writeNumberProperty("elapsedSeconds", s.elapsedSeconds());
            out.writeName("remainingSeconds");
            value(out, s.remainingSeconds());
            out.writeNumberProperty("picture", s.picture());
            properties(out, s.statistics());
            out.writeArrayPropertyStart("log");
            for (Status.Note note : s.notes()) {
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

    private static void properties(JsonGenerator out, Map<?, ?> values) {
        values.forEach((key, value) -> {
            out.writeName(key.toString());
            value(out, value);
        });
    }

    private static void value(JsonGenerator out, Object value) {
        if (value instanceof OptionalDouble number) {
            value(out, number.orElse(Double.NaN));
        } else if (value instanceof Boolean truth) {
            out.writeBoolean(truth);
        } else if (value instanceof Double number) {
            if (Double.isFinite(number)) {
                out.writeNumber(number);
            } else {
                out.writeNull();
            }
        } else if (value instanceof Number number) {
            out.writeNumber(number.longValue());
        } else if (value instanceof Map<?, ?> map) {
            out.writeStartObject();
            properties(out, map);
            out.writeEndObject();
        } else if (value instanceof List<?> list) {
            out.writeStartArray();
            list.forEach(one -> value(out, one));
            out.writeEndArray();
        } else {
            out.writeString(value.toString());
        }
    }
}
