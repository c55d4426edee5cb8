package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.ChosenSettings;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.Shading;
import enlightenment.scene.ToyMethod;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A method from outside and physical shading in scene files and in the schema. */
class MethodExtensionFilesTest {
    private static String scene(String parts) {
        return "{ \"image\": { \"width\": 8, \"height\": 4 },"
                + " \"camera\": { \"type\": \"perspective\", \"eye\": [0, 0, -5], \"lookAt\": [0, 0, 0], \"fieldOfView\": 40 },"
                + " \"objects\": [], " + parts + " }";
    }

    private static Scene read(String parts) {
        return SceneReader.readString(scene(parts), Path.of(""), "a scene");
    }

    private static Scene again(Scene scene) {
        return SceneReader.readString(SceneWriter.toJson(scene, Path.of("")), Path.of(""), "again");
    }

    @Test
    void aSceneMayAskForAMethodFromOutsideAndItsSettings() {
        Scene s = read(
                "\"render\": { \"method\": \"toy\", \"toyRays\": 5, \"toyShape\": \"square\", \"shadowSamples\": 3 }");
        assertEquals("toy", s.render().method().word());
        RenderSettings settings = RenderSettings.of(s);
        assertEquals(new ToyMethod.Settings(5, "square"), ToyMethod.Settings.of(settings));
        assertEquals(3, BuiltInMethod.RayTraceSettings.of(settings).shadowSamples());
        assertEquals(s, again(s));
    }

    @Test
    void settingsOfAMethodFromOutsideMayStandBesideOneOfOurs() {
        Scene s = read("\"render\": { \"method\": \"raytrace\", \"toyRays\": 5 }");
        assertEquals(ChosenSettings.NONE.with(ToyMethod.RAYS, 5), s.render().chosen());
        assertEquals(s, again(s));
    }

    @Test
    void itsValuesAreCheckedAsOurs() {
        List<Problem> problems = Documents.problems(
                scene("\"render\": { \"toyRays\": 65, \"toyShape\": \"flat\", \"toy\": 1 }"), Path.of(""));
        assertEquals(
                List.of("/render/toyRays", "/render/toyShape", "/render/toy"),
                problems.stream().map(Problem::pointer).toList());
        assertTrue(problems.get(0).message().contains("1..64"), problems.toString());
        assertTrue(problems.get(1).message().contains("\"round\", \"square\""), problems.toString());
    }

    @Test
    void theSchemaOfTheProgramHasItAndTheDocumentedOneHasNot() {
        JsonNode render =
                JsonMapper.builder().build().readTree(SceneSchema.text()).at("/$defs/render/properties");
        List<String> words = render.get("method")
                .get("enum")
                .valueStream()
                .map(JsonNode::asString)
                .toList();
        assertTrue(words.contains("toy"), words.toString());
        assertEquals(64, render.get("toyRays").get("maximum").asInt());
        assertEquals("round", render.get("toyShape").get("default").asString());
        assertTrue(!SceneSchema.text(BuiltInMethod.ALL).contains("toy"));
        assertTrue(!SceneSchema.text(BuiltInMethod.ALL).contains("@"));
    }

    @Test
    void physicalShadingIsReadAndWritten() {
        assertEquals(
                Shading.Physical.DEFAULT,
                read("\"shading\": { \"model\": \"physical\" }").shading());
        Scene s = read("\"shading\": { \"model\": \"physical\", \"maxBounces\": 0,"
                + " \"background\": { \"linear\": [1e30, 0.1, 0] } }");
        assertEquals(new Shading.Physical(OptionalInt.of(0), new Rgb(1e30, 0.1, 0)), s.shading());
        assertEquals(s, again(s));
    }

    @Test
    void aBackgroundThatAScreenShowsIsDecodedOnce() {
        Scene s = read("\"shading\": { \"model\": \"physical\", \"background\": \"#804020\" }");
        Rgb light = Rgb.of(DisplayRgb.ofBytes(0x80, 0x40, 0x20));
        assertEquals(new Shading.Background.Constant(light), ((Shading.Physical) s.shading()).background());
        assertEquals(s, again(s));
        Scene written = read("\"shading\": { \"model\": \"physical\", \"background\": { \"linear\": [" + light.r()
                + ", " + light.g() + ", " + light.b() + "] } }");
        assertEquals(s, written);
    }
}
