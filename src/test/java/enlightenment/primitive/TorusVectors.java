package enlightenment.primitive;

import enlightenment.math.Vec3;
import java.io.IOException;
import java.io.InputStream;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** Reads the tori of {@code intersection-vectors.jsonl}: rays with exact distances to 25 digits. */
final class TorusVectors {
    private TorusVectors() {}

    /** One ray against one torus: numeric fields by name, t as it is written. */
    static final class Vector {
        String kind;
        String scenario;
        Vec3 center;
        Vec3 axis;
        Vec3 origin;
        Vec3 direction;
        double major;
        double minor;
        boolean hit;
        BigDecimal t;
        double tolerance;
        double margin;

        TorusPrimitive torus() {
            return new TorusPrimitive(center, axis.normalized(), major, minor);
        }

        private void set(String name, JsonParser json) {
            switch (name) {
                case "kind" -> kind = json.getString();
                case "scenario" -> scenario = json.getString();
                case "center" -> center = vec3(json);
                case "axis" -> axis = vec3(json);
                case "origin" -> origin = vec3(json);
                case "direction" -> direction = vec3(json);
                case "major" -> major = json.getDoubleValue();
                case "minor" -> minor = json.getDoubleValue();
                case "hit" -> hit = json.getBooleanValue();
                case "t" -> t = new BigDecimal(json.getString());
                case "tTol" -> tolerance = Double.parseDouble(json.getString());
                case "marginEpsD" -> margin = json.getDoubleValue();
                default -> json.skipChildren();
            }
        }

        private static Vec3 vec3(JsonParser json) {
            json.nextToken();
            double x = json.getDoubleValue();
            json.nextToken();
            double y = json.getDoubleValue();
            json.nextToken();
            double z = json.getDoubleValue();
            json.nextToken();
            return new Vec3(x, y, z);
        }
    }

    static List<Vector> read() throws IOException {
        List<Vector> tori = new ArrayList<>();
        try (InputStream in =
                        Objects.requireNonNull(TorusVectors.class.getResourceAsStream("intersection-vectors.jsonl"));
                JsonParser json = new JsonFactory().createParser(ObjectReadContext.empty(), in)) {
            while (json.nextToken() == JsonToken.START_OBJECT) {
                Vector v = new Vector();
                while (json.nextToken() != JsonToken.END_OBJECT) {
                    String name = json.currentName();
                    json.nextToken();
                    v.set(name, json);
                }
                if (v.kind.equals("torus")) {
                    tori.add(v);
                }
            }
        }
        return tori;
    }
}
