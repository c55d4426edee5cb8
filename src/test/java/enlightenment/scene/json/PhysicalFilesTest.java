package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.Shading;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What scene files say about light and matter. */
class PhysicalFilesTest {
    @TempDir
    Path folder;

    private static String scene(String parts) {
        return "{\"image\": {\"width\": 4, \"height\": 2}, \"camera\": {\"type\": \"orthographic\", \"eye\": [0, 0, -9], \"lookAt\": [0, 0, 0],"
                + " \"height\": 5}, \"shading\": {\"model\": \"physical\"}, " + parts
                + (parts.contains("\"objects\"") ? "}" : ", \"objects\": []}");
    }

    private Scene read(String parts) {
        return Documents.read(scene(parts), folder);
    }

    private Scene again(Scene scene) {
        return Documents.read(SceneWriter.toJson(scene, folder), folder);
    }

    private Material material(String keys) {
        Scene s = read("\"materials\": {\"m\": {" + keys + "}}");
        assertEquals(s, again(s));
        return s.materials().get("m");
    }

    private Light light(String keys) {
        Scene s = read("\"lights\": [{" + keys + "}]");
        assertEquals(s, again(s));
        return s.lights().get(0);
    }

    @Test
    void aNumberStandsForAllThreeBands() {
        String lamp = "\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1, \"color\": \"#fff\", \"power\": ";
        assertEquals(light(lamp + "40"), light(lamp + "[40, 40, 40]"));
        String ember = "\"type\": \"matte\", \"color\": \"#000\", \"radiance\": ";
        assertEquals(material(ember + "2.5"), material(ember + "[2.5, 2.5, 2.5]"));
    }

    @Test
    void aDistantLightIsAsWideAsTheSunAndOfIrradianceOneUnlessItSaysOtherwise() {
        String key = "\"type\": \"distant\", \"direction\": [1, -2, 0.5]";
        assertEquals(new Light.Distant(new Vec3(1, -2, 0.5), Rgb.WHITE), light(key));
        assertEquals(
                new Light.Distant(new Vec3(1, -2, 0.5), 2, DisplayRgb.BLACK, Emission.irradiance(new Rgb(3, 2, 1))),
                light(key + ", \"color\": \"#000\", \"angle\": 2, \"irradiance\": [3, 2, 1]"));
    }

    @Test
    void whatALightGivesIsItsLinearColourTimesItsEmission() {
        Light lamp = light(
                "\"type\": \"point\", \"position\": [0, 0, 0], \"color\": {\"linear\": [0.5, 2, 0]}, \"intensity\": [3, 4, 5]");
        assertEquals(new Rgb(1.5, 8, 0), lamp.emitted());
        Rgb brown = Rgb.of(DisplayRgb.ofBytes(0x80, 0x40, 0x20));
        lamp = light("\"type\": \"point\", \"position\": [0, 0, 0], \"color\": \"#804020\"");
        assertEquals(brown, lamp.emitted());
        assertEquals(Emission.INTENSITY_1, lamp.emission());
    }

    @Test
    void aLightWithASurfaceHasRadianceOne() {
        Light.Rectangle lamp = (Light.Rectangle)
                light(
                        "\"type\": \"rectangle\", \"corners\": [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]], \"color\": \"#fff\"");
        assertEquals(Emission.RADIANCE_1, lamp.emission());
        assertTrue(lamp.twoSided());
    }

    @Test
    void metalsHaveConstantsOrNone() {
        assertEquals(
                Glossy.of(Texture.of(DisplayRgb.WHITE), 0.25),
                material("\"type\": \"glossy\", \"color\": \"#fff\", \"roughness\": 0.25"));
        Glossy metal = (Glossy) material(
                "\"type\": \"glossy\", \"color\": \"#fff\", \"roughness\": 0.25, \"eta\": 0.5, \"k\": [3, 2, 1]");
        assertEquals(Optional.of(new Glossy.Conductor(Rgb.gray(0.5), new Rgb(3, 2, 1))), metal.conductor());
        assertTrue(metal.multipleScattering());
    }

    @Test
    void metalsHaveNames() {
        for (Glossy.Metal metal : Glossy.Metal.values()) {
            Glossy named = Glossy.metal(Texture.of(DisplayRgb.WHITE), metal.conductor(), 0.25);
            for (String word : List.of(metal.word(), metal.symbol())) {
                assertEquals(named, material("\"type\": \"glossy\", \"roughness\": 0.25, \"metal\": \"" + word + "\""));
            }
        }
    }

    @Test
    void lightIsNeverDecoded() {
        Material.Matte m = (Material.Matte) material("\"type\": \"matte\", \"color\": {\"linear\": [0.1, 0.2, 0.3]}");
        assertEquals(new Rgb(0.1, 0.2, 0.3), ((Texture.Solid) m.color()).color().linear());
    }

    @Test
    void theDisplayPartIsLeftOutWhereItSaysNothing() {
        Scene s = read("\"display\": {}");
        assertEquals(Scene.Display.DEFAULT, s.display());
        assertFalse(SceneWriter.toJson(s, folder).contains("display"));
        s = read("\"display\": {\"exposure\": 1.5, \"tone\": \"filmic\"}");
        assertEquals(new Scene.Display(1.5, DisplayCurve.Tone.FILMIC), s.display());
        assertEquals(s, again(s));
    }

    @Test
    void theExposureAndTheLightsCanBeAnimated() {
        String animation =
                """
                "display": {"exposure": 0},
                "lights": [{"type": "point", "position": [0, 0, 0], "color": {"linear": [1, 1, 1]}, "intensity": [1, 1, 1]}],
                "animation": {"frames": 11, "framesPerSecond": 25, "tracks": [
                  {"target": "/display/exposure", "keys": {"0": 0, "10": 5}},
                  {"target": "/lights/0/color/linear/2", "keys": {"0": 1, "10": 0}},
                  {"target": "/lights/0/intensity/0", "keys": {"0": 1, "10": 11}}]}
                """;
        Scene s = read(animation);
        assertEquals(s, again(s));
        String text = SceneWriter.toJson(s, folder);
        Scene fifth = SceneReader.readBytes(
                text.getBytes(java.nio.charset.StandardCharsets.UTF_8), folder, "", java.util.OptionalInt.of(5));
        assertEquals(2.5, fifth.display().exposure());
        assertEquals(new Rgb(6, 1, 0.5), fifth.lights().get(0).emitted());
    }

    @Test
    void aMediumIsGivenByItsLookOrByItsPhysics() {
        Material.Scattering wax =
                (Material.Scattering) material("\"type\": \"scattering\", \"color\": \"#fff\", \"meanFreePath\": 0.5");
        assertEquals(Material.Scattering.of(Medium.Colored.of(DisplayRgb.WHITE, Rgb.gray(0.5))), wax);
        Material.Scattering milk = (Material.Scattering) material(
                "\"type\": \"scattering\", \"scatteringCoefficient\": [6, 5, 3], \"absorptionCoefficient\": 0.5,"
                        + " \"anisotropy\": -0.25");
        assertEquals(new Medium.Coefficients(new Rgb(6, 5, 3), Rgb.gray(0.5), -0.25), milk.medium());
        assertEquals(1, milk.indexOfRefraction());
    }

    @Test
    void surroundingsAreAPictureThatHasANameOrASky() {
        Documents.withImage(folder);
        String picture = "{\"model\": \"physical\", \"background\": {\"texture\": \"room\", \"rotation\": 90},"
                + " \"medium\": {\"color\": \"#fff\", \"meanFreePath\": 40}}, \"textures\": {\"room\": {\"file\": \"ice.png\"}}";
        Scene s = Documents.read(scene("\"name\": \"x\"").replace("{\"model\": \"physical\"}", picture), folder);
        Shading.Physical shading = (Shading.Physical) s.shading();
        Texture.File room = (Texture.File) s.textures().get("room");
        assertEquals(new Shading.Background.Picture(room, Rgb.WHITE, 90), shading.background());
        assertEquals(Optional.of(Medium.Colored.of(DisplayRgb.WHITE, Rgb.gray(40))), shading.medium());
        assertEquals(s, again(s));
        String sky = "{\"model\": \"physical\", \"background\": {\"type\": \"sky\", \"elevation\": 30}}";
        s = Documents.read(scene("\"name\": \"x\"").replace("{\"model\": \"physical\"}", sky), folder);
        assertEquals(Shading.Background.Sky.of(30, 0), ((Shading.Physical) s.shading()).background());
        assertEquals(s, again(s));
    }

    @Test
    void ultravioletLightHasNoColour() {
        Light lamp = light(
                "\"type\": \"point\", \"position\": [0, 0, 0], \"color\": {\"linear\": [0.5, 2, 0]}, \"ultraviolet\": 3");
        assertEquals(3, lamp.ultraviolet());
        assertEquals(Emission.INTENSITY_1.withUltraviolet(3), lamp.emission());
    }

    @Test
    void dyesAndDispersionDoNotStandTogether() {
        String both =
                "\"materials\": {\"prism\": {\"type\": \"glass\", \"color\": \"#fff\", \"indexOfRefraction\": 1.6,"
                        + " \"dispersion\": 36}, \"marker\": {\"type\": \"fluorescent\", \"color\": \"#fff\", \"absorption\":"
                        + " [320, 450], \"emission\": [500, 600], \"yield\": 0.5}}";
        Documents.read(scene(both), folder);
        String objects = ", \"objects\": [{\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1, \"material\":"
                + " \"prism\"}, {\"type\": \"sphere\", \"center\": [4, 0, 0], \"radius\": 1, \"material\": \"marker\"}]";
        Problem problem = Documents.problem(scene(both + objects), folder);
        assertEquals("/materials/prism/dispersion", problem.pointer());
        assertTrue(problem.message().contains("(/materials/marker)"), problem.message());
    }

    @Test
    void aClassicSceneMayHaveANamedMetalButNoObjectOfIt() {
        String metal = "\"materials\": {\"brass\": {\"type\": \"glossy\", \"color\": \"#fc8\", \"roughness\": 0.5}}";
        String ball =
                ", \"objects\": [{\"type\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 1, \"material\": \"brass\"}]";
        Documents.read(scene(metal).replace("physical", "classic"), folder);
        Documents.read(scene(metal + ball), folder);
        Problem problem = Documents.problem(scene(metal + ball).replace("physical", "classic"), folder);
        assertEquals("/materials/brass/type", problem.pointer());
    }
}
