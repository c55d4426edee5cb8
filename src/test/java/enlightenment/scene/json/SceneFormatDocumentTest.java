package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.material.Texture;
import enlightenment.mesh.MeshFiles;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Holds {@code docs/guide/scene-format.md}, the schema and the reader together. */
class SceneFormatDocumentTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final JsonNode DEFINITIONS =
            JSON.readTree(SceneSchema.text(BuiltInMethod.ALL)).get("$defs");
    private static final Pattern CODE = Pattern.compile("`([^`]*)`");

    /** Keys of all objects, which stand above the table. */
    private static final Set<String> ABOVE_THE_TABLE = Set.of("type", "material", "name");

    private static String document;

    /** A key as a table explains it; type "" where the table has no types, default "" where there is none. */
    private record Row(String type, String key, String ifMissing, String text) {}

    @BeforeAll
    static void read() throws IOException {
        document = Files.readString(Documents.projectFolder().resolve("docs/guide/scene-format.md"));
    }

    /** The cells of the first table below a heading, without its head. */
    private static List<List<String>> table(String heading) {
        int start = document.indexOf("\n" + heading + "\n");
        assertTrue(start >= 0, heading);
        String section = document.substring(start, endOfSection(start + 2));
        List<List<String>> rows = new ArrayList<>();
        section.lines().filter(l -> l.startsWith("|")).forEach(l -> {
            List<String> cells =
                    Arrays.asList(l.substring(1, l.lastIndexOf('|')).split("(?<!\\\\)\\|", -1));
            rows.add(cells.stream().map(String::strip).toList());
        });
        return rows.subList(2, rows.size());
    }

    private static int endOfSection(int from) {
        int end = document.indexOf("\n#", from);
        return end < 0 ? document.length() : end;
    }

    private static List<String> codes(String cell) {
        List<String> codes = new ArrayList<>();
        for (Matcher m = CODE.matcher(cell); m.find(); ) {
            codes.add(m.group(1));
        }
        return codes;
    }

    /** The keys of a family's table by their types; those of the row "all" are every type's. */
    private static Map<String, List<Row>> rows(Family<?> family, String heading, boolean hasDefaults) {
        Map<String, List<Row>> byType = new LinkedHashMap<>();
        List<String> types = List.of();
        for (List<String> cells : table(heading)) {
            if (cells.get(0).equals("all")) {
                types = List.copyOf(byType.keySet());
            } else if (!cells.get(0).isEmpty()) {
                types = List.of(codes(cells.get(0)).get(0));
                byType.putIfAbsent(types.get(0), new ArrayList<>());
            }
            String text = cells.get(cells.size() - 1);
            for (String key : codes(cells.get(1))) {
                String ifMissing = hasDefaults ? ifMissing(cells.get(2), key) : "";
                types.forEach(type -> byType.get(type).add(new Row(type, key, ifMissing, text)));
            }
        }
        assertEquals(List.copyOf(family.types()), List.copyOf(byType.keySet()), heading);
        return byType;
    }

    /** Of a row of several keys, "`key`: default" gives the default of one. */
    private static String ifMissing(String cell, String key) {
        if (!cell.contains("`: ")) {
            return cell;
        }
        return cell.startsWith("`" + key + "`: ") ? cell.substring(key.length() + 4) : "";
    }

    /** A family, the heading of its table, and whether the table has a column for defaults. */
    record Section(Family<?> family, String heading, boolean hasDefaults) {}

    static List<Section> sections() {
        return List.of(
                new Section(Cameras.FAMILY, "### Camera", true),
                new Section(Shapes.FAMILY, "### Objects", true),
                new Section(Materials.FAMILY, "### Materials", true),
                new Section(Textures.FAMILY, "### Textures", true),
                new Section(Lights.FAMILY, "### Lights", true),
                new Section(Backgrounds.FAMILY, "#### Surroundings", true));
    }

    @Test
    void everyFamilyHasItsSection() {
        assertEquals(
                Set.copyOf(Vocabulary.families()),
                Set.copyOf(sections().stream().map(Section::family).toList()));
    }

    @ParameterizedTest
    @MethodSource("sections")
    void everyKindIsExplainedWithItsKeysDefaultsAndRanges(Section section) {
        rows(section.family(), section.heading(), section.hasDefaults()).forEach((type, rows) -> {
            Keys keys = section.family().keys(type);
            Set<String> inTheTable = new TreeSet<>(keys.all());
            inTheTable.removeAll(section.family() == Shapes.FAMILY ? ABOVE_THE_TABLE : Set.of("type"));
            assertEquals(inTheTable, new TreeSet<>(rows.stream().map(Row::key).toList()), keys.schemaName());
            rows.forEach(row -> check(row, keys));
        });
    }

    /** A table of keys alone. */
    record Part(String heading, List<Keys> keys) {}

    static List<Part> parts() {
        return List.of(
                new Part("#### Classic", List.of(PartKeys.CLASSIC_SHADING)),
                new Part("#### Physical", List.of(PartKeys.PHYSICAL_SHADING)),
                new Part("#### Media", List.of(PartKeys.MEDIUM)),
                new Part("#### Lenses", List.of(PartKeys.LENS)),
                new Part("### Meshes", List.of(Meshes.NAMED)),
                new Part("### Transforms", Transforms.ALL),
                new Part("### Groups", List.of(Groups.OBJECT)),
                new Part("### Display", List.of(PartKeys.DISPLAY)),
                new Part("### Render", List.of(RenderPart.keys(BuiltInMethod.ALL))),
                new Part("### Animation", List.of(PartKeys.ANIMATION, PartKeys.TRACK)));
    }

    @ParameterizedTest
    @MethodSource("parts")
    void everyPartIsExplainedWithItsKeysDefaultsAndRanges(Part part) {
        Map<String, Row> rows = new LinkedHashMap<>();
        for (List<String> cells : table(part.heading())) {
            String text = cells.get(cells.size() - 1);
            codes(cells.get(0))
                    .forEach(key -> rows.put(key, new Row("", key, cells.size() == 3 ? cells.get(1) : "", text)));
        }
        Set<String> expected = new TreeSet<>();
        for (Keys keys : part.keys()) {
            expected.addAll(keys.all());
            keys.all().forEach(key -> check(rows.get(key), keys));
        }
        assertEquals(expected, new TreeSet<>(rows.keySet()), part.heading());
    }

    @Test
    void theTableOfPartsNamesAllOfThemAndWhichMustBeThere() {
        Set<String> required = new TreeSet<>();
        Set<String> all = new TreeSet<>();
        for (List<String> cells : table("## The parts")) {
            String key = codes(cells.get(0)).get(0);
            all.add(key);
            if (cells.get(1).equals("required")) {
                required.add(key);
            }
        }
        assertEquals(new TreeSet<>(PartKeys.SCENE.all()), all);
        assertEquals(new TreeSet<>(PartKeys.SCENE.required()), required);
    }

    /** A default where the key may be missing, the one that the schema has; and the range that the schema has. */
    private static void check(Row row, Keys keys) {
        String where = keys.schemaName() + "/" + row.key();
        assertEquals(keys.required().contains(row.key()), row.ifMissing().isEmpty(), where);
        JsonNode schema = DEFINITIONS.get(keys.schemaName()).get("properties").get(row.key());
        if (schema.has("default")) {
            assertEquals(schema.get("default"), JSON.readTree(row.ifMissing().replace("`", "")), where);
        } else if (!row.ifMissing().isEmpty()) {
            assertEquals("none", row.ifMissing(), where);
        }
        Matcher range = Pattern.compile("(-?\\d+(?:\\.\\d+)?)\\.\\.(\\d+)").matcher(row.text());
        if (range.find()) {
            assertEquals(schema.get("minimum").decimalValue().toString(), range.group(1), where);
            assertEquals(schema.get("maximum").decimalValue().toString(), range.group(2), where);
        }
        boolean bounded = schema.has("minimum") && schema.has("maximum");
        boolean isSaid = range.reset().find() || row.text().matches(".*whole number of (32|64) bits.*");
        assertTrue(!bounded || isSaid, where);
    }

    @Test
    void theExampleIsAScene() {
        int start = document.indexOf("```jsonc\n") + "```jsonc\n".length();
        String example = document.substring(start, document.indexOf("```", start));
        assertEquals(3, Documents.read(example, Path.of("")).objects().size());
    }

    private static Stream<String> refused(Family<?> family) {
        return Stream.concat(
                family.plannedTypes().keySet().stream(),
                family.types().stream().flatMap(t -> family.refusedKeys(t).keySet().stream()));
    }

    @Test
    void everyWordIsExplained() {
        Stream.of(
                        Method.words(Method.selectable(BuiltInMethod.ALL)),
                        Shadings.models(),
                        Fields.words(Texture.Filter.class),
                        Fields.words(MeshFiles.Origin.Normals.class),
                        Fields.words(DisplayCurve.Tone.class),
                        Fields.words(Texture.Amount.Channel.class),
                        Fields.words(Texture.Encoding.class))
                .flatMap(List::stream)
                .forEach(w -> assertTrue(document.contains("`\"" + w + "\"`"), w));
        Stream.concat(
                        Vocabulary.families().stream().flatMap(SceneFormatDocumentTest::refused),
                        Stream.concat(PartKeys.LINEAR_COLOR.all().stream(), PartKeys.AMOUNT_REFERENCE.all().stream()))
                .forEach(w -> assertTrue(document.contains("`" + w + "`") || document.contains("\"" + w + "\": "), w));
    }
}
