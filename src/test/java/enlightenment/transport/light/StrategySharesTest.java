package enlightenment.transport.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.Scattering;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.transport.path.CausticPassShare;
import enlightenment.transport.state.PathEvent;
import enlightenment.transport.state.PathState;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Every kind of path from the eye to a light, up to five segments: it is sampled either from the eye (by BSDF sampling, next-event
 * estimation, or images in mirrors, which divide it between them: {@code NextEventSharesTest}, {@code MirrorCausticsTest}) or by the caustic
 * pass. Both decide by themselves whether they sample it, each in its own order of the vertices, and their shares add up to 1.
 */
class StrategySharesTest {
    private static final int MOST_EVENTS = 4;
    private static final int SMALL = 0;
    private static final int LARGE = 1;

    /** What vertices are made of. Rough interfaces of glass may have narrow lobes or wide ones. */
    private enum Matter {
        MIRROR("\"mirror\""),
        CLEAR_GLASS("\"glass\", \"indexOfRefraction\": 1.5"),
        POLISHED_METAL("\"glossy\", \"roughness\": 0.2"),
        METAL("\"glossy\", \"roughness\": 0.6"),
        MATTE("\"matte\""),
        POLISHED_GLASS("\"glass\", \"indexOfRefraction\": 1.5, \"roughness\": 0.2"),
        FROSTED_GLASS("\"glass\", \"indexOfRefraction\": 1.5, \"roughness\": 0.6"),
        FOG(null),
        FOG_IN_GLASS(null);

        /** Null for media, whose phase function decides nothing. */
        final String material;

        Matter(String material) {
            this.material = material;
        }
    }

    private static CompiledScene scene;
    private static CausticPassShare share;
    private static final Bsdf[] BSDF = new Bsdf[Matter.values().length];

    @BeforeAll
    static void compile() {
        StringBuilder objects = new StringBuilder();
        for (Matter matter : Matter.values()) {
            if (matter.material != null) {
                objects.append(objects.isEmpty() ? "" : ", ")
                        .append("{ \"type\": \"sphere\", \"center\": [0, 0, " + matter.ordinal()
                                + "], \"radius\": 0.1, ")
                        .append("\"material\": { \"color\": \"#ffffff\", \"type\": " + matter.material + " } }");
            }
        }
        String text =
                """
                { "image": { "width": 8, "height": 8 }, "shading": { "model": "physical" },
                  "camera": { "type": "perspective", "eye": [0, 3, -4], "lookAt": [0, 0, 0], "fieldOfView": 50 },
                  "lights": [
                    { "type": "sphere", "center": [-1.2, 2, 0.4], "radius": 0.2, "color": "#ffffff", "radiance": [9, 9, 9] },
                    { "type": "sphere", "center": [1.2, 1, 3], "radius": 0.9, "color": "#ffffff", "radiance": [2, 2, 2] } ],
                  "objects": [""";
        Scene description = SceneReader.readString(text + objects + "] }", Path.of(""), "");
        scene = SceneCompiler.compile(description, RenderSettings.of(description));
        share = new CausticPassShare(scene.physical.caustics);
        for (int id = 0; id < scene.primitives.length; id++) {
            if (scene.object[id] < Matter.FOG.ordinal() && scene.physical.lightOf(id, 0) < 0) {
                BSDF[scene.object[id]] = scene.material(id, 0).bsdf;
            }
        }
        for (Matter matter : Matter.values()) {
            boolean isNarrow = matter == Matter.POLISHED_METAL || matter == Matter.POLISHED_GLASS;
            if (matter.material != null) {
                assertEquals(isNarrow, share.isNarrow(BSDF[matter.ordinal()]), matter::name);
            }
        }
        assertTrue(scene.physical.caustics.takesNarrow(SMALL));
        assertFalse(scene.physical.caustics.takesNarrow(LARGE));
    }

    private static List<List<Matter>> paths() {
        List<List<Matter>> all = new ArrayList<>();
        all.add(List.of());
        for (int k = 0; k < all.size(); k++) {
            for (Matter next : all.get(k).size() < MOST_EVENTS ? Matter.values() : new Matter[0]) {
                List<Matter> longer = new ArrayList<>(all.get(k));
                longer.add(next);
                all.add(longer);
            }
        }
        return all;
    }

    private static PathEvent event(Matter matter) {
        return switch (matter) {
            case MIRROR, CLEAR_GLASS -> PathEvent.SPECULAR;
            case POLISHED_METAL -> PathEvent.NARROW;
            case METAL, MATTE -> PathEvent.WIDE;
            case POLISHED_GLASS, FROSTED_GLASS -> PathEvent.ROUGH_INTERFACE;
            case FOG -> PathEvent.MEDIUM;
            case FOG_IN_GLASS -> PathEvent.REFRACTIVE_MEDIUM;
        };
    }

    /** The share of paths from the eye, whose vertices are left as the path integrator leaves them. */
    private static double fromEye(List<Matter> path, int light) {
        PathState state = new PathState();
        state.begin();
        boolean leaves = false;
        for (Matter matter : path) {
            boolean isNarrow = matter.material != null && share.isNarrow(BSDF[matter.ordinal()]);
            leaves = isNarrow && state.isNarrowSampledByCausticPass();
            switch (event(matter)) {
                case SPECULAR -> state.extendSpecular(matter == Matter.MIRROR ? 0 : -1);
                case REFRACTIVE_MEDIUM -> state.extendWithoutDirect();
                default -> state.extend(event(matter), new Scattering(), leaves);
            }
        }
        double weight = share.weightOfHit(state, new Ray(), light);
        // Next-event estimation leaves out what it is told to: where the hit has no share it must have none, and
        // otherwise
        // they divide the light between them.
        boolean isLeftOut = leaves && scene.physical.caustics.takesNarrow(light);
        assertEquals(isLeftOut, state.hasDirect && weight == 0, path::toString);
        return weight;
    }

    /** The share of the caustic pass, whose paths are followed from the light: 1 if the vertex before the eye is connected to that. */
    private static double fromLight(List<Matter> path, int light) {
        CausticCount count = new CausticCount(scene.physical.caustics, true);
        count.begin(light);
        for (int k = path.size() - 1; k >= 0; k--) {
            Matter matter = path.get(k);
            boolean isMedium = matter.material == null;
            if (isMedium
                    ? matter == Matter.FOG_IN_GLASS || !count.counts()
                    : !count.continues(BSDF[matter.ordinal()])) {
                return 0;
            }
            if (k == 0) {
                boolean isInterface = event(matter) == PathEvent.ROUGH_INTERFACE;
                return isMedium || !isInterface && count.countsAt(BSDF[matter.ordinal()]) ? 1 : 0;
            }
            if (!isMedium) {
                count.leave(event(matter) == PathEvent.SPECULAR, new Hit(), 1);
            }
        }
        return 0;
    }

    @Test
    void thePathIntegratorAndTheCausticPassAddUpToOne() {
        int ofPass = 0;
        for (List<Matter> path : paths()) {
            for (int light : new int[] {SMALL, LARGE}) {
                double fromLight = fromLight(path, light);
                assertEquals(1, fromEye(path, light) + fromLight, () -> path + ", light " + light);
                ofPass += fromLight > 0 ? 1 : 0;
            }
        }
        assertTrue(ofPass > 1000, "paths of the pass: " + ofPass);
    }
}
