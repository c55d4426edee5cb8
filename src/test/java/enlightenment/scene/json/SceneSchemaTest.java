package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import enlightenment.camera.Camera;
import enlightenment.color.DisplayCurve;
import enlightenment.material.Texture;
import enlightenment.mesh.MeshFiles;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Holds the schema and the reader together. */
class SceneSchemaTest {
    private static final JsonMapper JSON = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_JAVA_COMMENTS)
            .enable(DeserializationFeature.USE_BIG_DECIMAL_FOR_FLOATS)
            .build();
    private static final SchemaRegistry REGISTRY =
            SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12);
    private static final JsonNode TEXT = JSON.readTree(SceneSchema.text(BuiltInMethod.ALL));
    private static final Schema SCHEMA = REGISTRY.getSchema(TEXT);

    private static List<String> complaints(String json) {
        return SCHEMA.validate(JSON.readTree(json)).stream()
                .map(Object::toString)
                .toList();
    }

    @Test
    void theDocumentedSchemaIsTheProgramsSchema() throws IOException {
        byte[] documented = Files.readAllBytes(Documents.projectFolder().resolve("docs/scene.schema.json"));
        assertArrayEquals(documented, SceneSchema.text(BuiltInMethod.ALL).getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void theSchemaIsASchema() {
        assertEquals(
                "https://json-schema.org/draft/2020-12/schema",
                TEXT.get("$schema").asString());
        Schema meta = REGISTRY.getSchema(
                com.networknt.schema.SchemaLocation.of("https://json-schema.org/draft/2020-12/schema"));
        assertEquals(List.of(), meta.validate(TEXT));
    }

    static List<String> shippedNames() {
        return Documents.shippedNames();
    }

    @ParameterizedTest
    @MethodSource("shippedNames")
    void shippedScenesAreValid(String name) throws IOException {
        assertEquals(
                List.of(),
                complaints(Files.readString(
                        Documents.projectFolder().resolve("scenes").resolve(name))));
    }

    @Test
    void aDocumentWithEverythingIsValid() {
        assertEquals(List.of(), complaints(Documents.EVERYTHING));
    }

    static List<BadDocuments.Edit> edits() {
        return BadDocuments.FOR_THE_SCHEMA_TOO;
    }

    @ParameterizedTest
    @MethodSource("edits")
    void whatTheReaderRefusesTheSchemaRefuses(BadDocuments.Edit edit) {
        assertFalse(complaints(edit.document()).isEmpty());
    }

    @Test
    void aCubeNeedsAMaterialOrFaces() {
        assertFalse(complaints(Documents.withObjects("{\"type\": \"cube\", \"center\": [0, 0, 0], \"radius\": 1}"))
                .isEmpty());
    }

    @Test
    void bothKnowTheSameKeys() {
        Map<String, Set<String>> readers = new TreeMap<>();
        Vocabulary.all().forEach(keys -> readers.put(keys.schemaName(), new TreeSet<>(keys.all())));
        Map<String, Set<String>> schemas = new TreeMap<>();
        parts().forEach((name, part) ->
                schemas.put(name, new TreeSet<>(part.get("properties").propertyNames())));
        assertEquals(readers, schemas);
    }

    @Test
    void bothNeedTheSameKeys() {
        Map<String, Set<String>> readers = new TreeMap<>();
        Vocabulary.all().forEach(keys -> readers.put(keys.schemaName(), new TreeSet<>(keys.required())));
        Map<String, Set<String>> schemas = new TreeMap<>();
        parts().forEach((name, part) -> schemas.put(name, strings(part.get("required"))));
        assertEquals(readers, schemas);
    }

    @Test
    void noPartTakesUnknownKeys() {
        parts().forEach((name, part) ->
                assertFalse(part.get("additionalProperties").asBoolean(true), name));
    }

    @Test
    void bothKnowTheSameTypesAndWords() {
        for (Family<?> family : Vocabulary.families()) {
            Set<String> refs = new TreeSet<>();
            TEXT.get("$defs")
                    .get(family.name())
                    .get("oneOf")
                    .forEach(r -> refs.add(r.get("$ref").asString().substring("#/$defs/".length())));
            assertEquals(
                    family.keys().stream().map(Keys::schemaName).collect(Collectors.toCollection(TreeSet::new)), refs);
            for (String type : family.types()) {
                assertEquals(
                        type,
                        property(family.keys(type).schemaName(), "type")
                                .get("const")
                                .asString());
            }
        }
        assertEquals(
                words(Method.words(Method.selectable(BuiltInMethod.ALL))),
                strings(property("render", "method").get("enum")));
        assertEquals(
                Shadings.models(),
                List.of(
                        property("classicShading", "model").get("const").asString(),
                        property("physicalShading", "model").get("const").asString()));
        assertEquals(
                words(Fields.words(DisplayCurve.Tone.class)),
                strings(property("display", "tone").get("enum")));
        for (Keys keys : List.of(Meshes.NAMED, Shapes.FAMILY.keys("mesh"))) {
            assertEquals(
                    words(Fields.words(MeshFiles.Origin.Normals.class)),
                    strings(property(keys.schemaName(), "normals").get("enum")));
        }
        assertEquals(
                words(Fields.words(Texture.Filter.class)),
                strings(property("fileTexture", "filter").get("enum")));
        assertEquals(
                words(Fields.words(Texture.Encoding.class)),
                strings(property("fileTexture", "encoding").get("enum")));
    }

    @Test
    void bothKnowTheSameWordsOfCameras() {
        assertEquals(
                words(Fields.words(Camera.FieldOfViewAxis.class)),
                strings(property("perspectiveCamera", "fieldOfViewAxis").get("enum")));
        assertEquals(
                words(Fields.words(Camera.Handedness.class)),
                strings(TEXT.get("$defs").get("handedness").get("enum")));
    }

    @Test
    void thereAreNoWordsThatNothingHolds() {
        assertTrue(BadDocuments.FOR_THE_SCHEMA_TOO.size() > 80);
        assertEquals(Vocabulary.all().size(), parts().size());
    }

    @Test
    void aMissingKeyIsItsDefault(@TempDir Path folder) {
        Documents.withImage(folder);
        int compared = 0;
        for (String document : List.of(
                Documents.EVERYTHING,
                withCamera("perspective", "\"eye\": [0, 1, -3], \"lookAt\": [0, 1, 0], \"fieldOfView\": 30"),
                withCamera("orthographic", "\"eye\": [0, 1, -3], \"lookAt\": [0, 1, 0], \"height\": 5"),
                withCamera("panorama", "\"eye\": [0, 1, -3], \"lookAt\": [0, 1, 0]"))) {
            ObjectNode root = (ObjectNode) JSON.readTree(document);
            // Its tracks need the numbers that go.
            root.remove("animation");
            Map<ObjectNode, JsonNode> parts = new IdentityHashMap<>();
            parts.put(root, TEXT.get("$defs").get("scene"));
            parts.put((ObjectNode) root.get("shading"), TEXT.get("$defs").get("classicShading"));
            parts.put((ObjectNode) root.get("display"), TEXT.get("$defs").get("display"));
            parts.put((ObjectNode) root.get("render"), TEXT.get("$defs").get("render"));
            addKinds(parts, Cameras.FAMILY, List.of(root.get("camera")));
            addKinds(parts, Shapes.FAMILY, root.get("objects"));
            root.get("meshes")
                    .forEach(m -> parts.put((ObjectNode) m, TEXT.get("$defs").get(Meshes.NAMED.schemaName())));
            addKinds(parts, Materials.FAMILY, root.get("materials"));
            addKinds(parts, Textures.FAMILY, root.get("textures"));
            addKinds(parts, Lights.FAMILY, root.get("lights"));
            for (Map.Entry<ObjectNode, JsonNode> part : parts.entrySet()) {
                for (Map.Entry<String, JsonNode> property :
                        part.getValue().get("properties").properties()) {
                    if (property.getValue().has("default") && !isExcluded(part, property.getKey())) {
                        compareWithout(part.getKey(), property.getKey(), property.getValue(), root, folder);
                        compared++;
                    }
                }
            }
        }
        assertTrue(compared > 20, compared + " defaults");
    }

    /** Whether a key stands in the place of another one that the part has. */
    private static boolean isExcluded(Map.Entry<ObjectNode, JsonNode> part, String key) {
        Set<String> exclusive = strings(part.getValue().path("not").get("required"));
        boolean isExclusive = exclusive.contains(key)
                && exclusive.stream()
                        .anyMatch(k -> !k.equals(key) && part.getKey().has(k));
        Set<String> needed = strings(part.getValue().path("dependentRequired").get(key));
        return isExclusive
                || !needed.stream().allMatch(k -> part.getKey().has(k))
                || isBound(part.getValue().path("dependentSchemas"), part.getKey(), key);
    }

    /** Whether another key that the part has leaves one value for a key only. */
    private static boolean isBound(JsonNode dependent, ObjectNode part, String key) {
        return dependent.properties().stream()
                .anyMatch(d ->
                        part.has(d.getKey()) && d.getValue().path("properties").has(key));
    }

    private static String withCamera(String type, String keys) {
        String everything = Documents.EVERYTHING;
        int start = everything.indexOf("{", everything.indexOf("\"camera\""));
        int end = everything.indexOf("}", start);
        return everything.substring(0, start) + "{\"type\": \"" + type + "\", " + keys + everything.substring(end);
    }

    private static void addKinds(Map<ObjectNode, JsonNode> parts, Family<?> family, Iterable<JsonNode> nodes) {
        for (JsonNode node : nodes) {
            String type = node.path("type").asString(family.typeUnlessGiven());
            Keys keys = type.equals(Groups.TYPE) ? Groups.OBJECT : family.keys(type);
            parts.put((ObjectNode) node, TEXT.get("$defs").get(keys.schemaName()));
        }
    }

    private static void compareWithout(ObjectNode part, String key, JsonNode schema, ObjectNode root, Path folder) {
        JsonNode before = part.get(key);
        part.set(key, schema.get("default"));
        Scene withDefault = Documents.read(root.toString(), folder);
        part.remove(key);
        assertEquals(withDefault, Documents.read(root.toString(), folder), key);
        if (before != null) {
            part.set(key, before);
        }
    }

    private static Set<String> words(List<String> words) {
        return new TreeSet<>(words);
    }

    private static JsonNode property(String part, String key) {
        return TEXT.get("$defs").get(part).get("properties").get(key);
    }

    /** The definitions of objects with certain keys. */
    private static Map<String, JsonNode> parts() {
        Map<String, JsonNode> parts = new TreeMap<>();
        TEXT.get("$defs").properties().forEach(e -> {
            if (e.getValue().has("properties")) {
                parts.put(e.getKey(), e.getValue());
            }
        });
        return parts;
    }

    private static Set<String> strings(JsonNode array) {
        Set<String> strings = new TreeSet<>();
        if (array != null) {
            array.forEach(v -> strings.add(v.asString()));
        }
        return strings;
    }
}
