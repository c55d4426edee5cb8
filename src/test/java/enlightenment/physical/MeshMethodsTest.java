package enlightenment.physical;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * All methods make the same picture of smooth meshes as single paths from the eye. Where normals of matte meshes are bent, light that is carried
 * from the lights would be off by the cosines' ratio if it were not corrected: by up to a half.
 */
class MeshMethodsTest {
    private static final Map<String, Scene> SCENES = PartnerScenes.all();
    private static final PathTracedReferences REFERENCES = new PathTracedReferences(12, 3);

    private static RenderSettings settings(Scene scene, BuiltInMethod method) {
        return RenderSettings.of(scene).withMethod(method).withThreads(1);
    }

    @ParameterizedTest
    @CsvSource({
        "CLUSTER, 'smooth meshes of matte, mirror and glass'",
        "CLUSTER, smooth meshes of metal and coats",
        "CLUSTER, meshes whose normals are bent",
        "METROPOLIS, meshes whose normals are bent",
        "BIDIRECTIONAL, meshes whose normals are bent",
        "LIGHT, meshes whose normals are bent",
        "CLUSTER, meshes that refract smoothly",
        "METROPOLIS, meshes that refract smoothly",
        "BIDIRECTIONAL, meshes that refract smoothly",
        "LIGHT, hidden cube that refracts smoothly",
        "BIDIRECTIONAL, hidden cube that refracts smoothly",
        "METROPOLIS, 'smooth meshes of matte, mirror and glass'",
        "METROPOLIS, smooth meshes of metal and coats"
    })
    void othersMakeThePictureOfSinglePaths(BuiltInMethod method, String name) {
        Scene scene = SCENES.get(name);
        List<Image> traced = REFERENCES.of(name, scene);
        List<Image> others = Rendered.seeds(scene, settings(scene, method).withAntialias(3), 1, 12);
        Rendered.assertPartsAgree(traced, others, 156);
    }
}
