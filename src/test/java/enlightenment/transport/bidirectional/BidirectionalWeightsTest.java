package enlightenment.transport.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.bsdf.Bsdf;
import enlightenment.bsdf.HenyeyGreenstein;
import enlightenment.bsdf.Scattering;
import enlightenment.emitter.LightSample;
import enlightenment.emitter.SampledLight;
import enlightenment.film.SplatBatch;
import enlightenment.film.SplatScale;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.transport.light.BidirectionalLightTracer;
import enlightenment.world.CompiledScene;
import enlightenment.world.LightStarts;
import enlightenment.world.SceneCompiler;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.PhysicalLight;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The weights that two numbers per vertex tell are those that follow from the densities of all strategies, each multiplied out from one end
 * to the other: so those of all strategies that can make a path add up to 1.
 */
class BidirectionalWeightsTest {
    private static final double NEAR = 1e-4;
    private static final int SIDE = 64;

    private static final String SCENE =
            """
            { "image": { "width": 64, "height": 64 },
              "camera": CAMERA,
              "shading": SHADING,
              "materials": {
                "wax": { "type": "scattering", "scatteringCoefficient": [9, 6, 3], "absorptionCoefficient": [0.1, 0.3, 0.5],
                  "anisotropy": 0.3 },
                "jade": { "type": "scattering", "scatteringCoefficient": 4, "absorptionCoefficient": 0.5,
                  "indexOfRefraction": 1.3, "roughness": 0.5 },
                "white": { "type": "matte", "color": { "linear": [0.8, 0.7, 0.6] } },
                "clay": { "type": "matte", "color": { "linear": [0.5, 0.6, 0.7] }, "roughness": 0.8 },
                "mirror": { "type": "mirror", "color": { "linear": [0.9, 0.8, 0.9] } },
                "metal": { "type": "glossy", "color": { "linear": [0.9, 0.8, 0.6] }, "roughness": 0.6 },
                "glass": { "type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5 },
                "half": { "type": "glass", "color": "#a0d0ff", "indexOfRefraction": 1.4, "transparency": 0.6 },
                "frosted": { "type": "glass", "color": "#ffe0ff", "indexOfRefraction": 1.4, "roughness": 0.6 }
              },
              "lights": [
                { "type": "sphere", "center": [-0.9, 1.4, 0.2], "radius": 0.25, "color": "#ffffff", "radiance": 3 },
                { "type": "rectangle", "corners": [[0.2, 1.9, 0.6], [0.2, 1.9, 0], [1, 1.9, 0], [1, 1.9, 0.6]],
                  "color": "#ffffff", "radiance": 3, "twoSided": false },
                { "type": "rectangle", "corners": [[-1.5, 0.4, 1], [-1.5, 0.8, 1], [-1.2, 0.8, 0.7], [-1.2, 0.4, 0.7]],
                  "color": "#ffffff", "radiance": 2 },
                { "type": "point", "position": [0.1, 1.5, -0.7], "color": "#ffffff", "intensity": 0.3 }
              ],
              "objects": [
                { "type": "rectangle", "corners": [[-2, 0, -2], [-2, 0, 2], [2, 0, 2], [2, 0, -2]], "material": "white" },
                { "type": "rectangle", "corners": [[-2, 0, 2], [-2, 2, 2], [2, 2, 2], [2, 0, 2]], "material": "clay" },
                { "type": "rectangle", "corners": [[2, 0, 2], [2, 2, 2], [2, 2, -2], [2, 0, -2]], "material": "mirror" },
                { "type": "sphere", "center": [0, 0.5, 0.2], "radius": 0.4, "material": "glass" },
                { "type": "sphere", "center": [0.9, 0.4, 0.5], "radius": 0.35, "material": "frosted" },
                { "type": "sphere", "center": [-0.8, 0.4, 0.8], "radius": 0.35, "material": "metal" },
                { "type": "box", "min": [-0.6, 0.1, -0.8], "max": [-0.2, 0.5, -0.5], "material": "half" },
                { "type": "disk", "center": [0.6, 0.6, -0.6], "normal": [0.3, 0.2, 1], "radius": 0.4, "material": "glass" },
                { "type": "torus", "center": [0.6, 0.1, 1.2], "axis": [0, 1, 0], "majorRadius": 0.4, "minorRadius": 0.1,
                  "material": { "type": "matte", "color": "#804020", "radiance": [0.5, 1, 1] } }
                MORE
              ] }
            """;
    private static final String PERSPECTIVE =
            "{ \"type\": \"perspective\", \"eye\": [0, 1.2, -4], \"lookAt\": [0, 0.8, 0], \"fieldOfView\": 40 }";
    private static final String PARALLEL =
            "{ \"type\": \"orthographic\", \"eye\": [0.5, 1.5, -4], \"lookAt\": [0, 0.8, 0], \"height\": 3 }";

    private static final String PANORAMA =
            "{ \"type\": \"panorama\", \"eye\": [0.5, 1.2, -1.5], \"lookAt\": [0, 0.8, 0] }";

    private CompiledScene scene;
    private LightStarts starts;
    private EyeProjection eye;
    private final SampledLight choice = new SampledLight();
    private final LightSample sample = new LightSample();
    private final ReverseDensity reverse = new ReverseDensity();
    private int paths;
    private int throughDelta;
    private int inMedia;

    /** How many paths have vertices so near to each other that they are not compared. */
    private int near;

    private void read(String camera, boolean inFog) {
        String shading = "{ \"model\": \"physical\" }";
        String fog =
                """
                { "model": "physical", "medium": { "scatteringCoefficient": [0.2, 0.3, 0.4], "absorptionCoefficient": 0.05 } }
                """;
        String more =
                """
                , { "type": "sphere", "center": [-1.3, 0.3, -0.3], "radius": 0.3, "material": "wax" },
                { "type": "sphere", "center": [1.5, 0.3, -0.5], "radius": 0.3, "material": "jade" }
                """;
        Scene read = SceneReader.readString(
                SCENE.replace("CAMERA", camera)
                        .replace("SHADING", inFog ? fog : shading)
                        .replace("MORE", inFog ? more : ""),
                Path.of(""),
                "");
        scene = SceneCompiler.compile(read, RenderSettings.of(read));
        starts = scene.lightStarts(false);
        eye = EyeProjection.of(scene.camera);
    }

    /** A vertex that may be connected, with what lies between it and the next one towards the eye. */
    private final class Vertex {
        final Vec3 place;
        final Bsdf bsdf;

        /** As the path came to it, from one side or the other. */
        final Scattering s = new Scattering();

        final double survival;
        final boolean isInterface;

        /** The vertices that it is one of, and which; null for a point of a light. */
        final PathVertices of;

        final int number;

        /** Unit vectors to its neighbours. */
        Vec3 toLight;

        Vec3 toEye;

        /** Whether mirrors or glass are between it and the next one towards the eye; and the ratio of the squared indices. */
        boolean delta;

        double expansion = 1;

        Vertex(PathVertices v, int k) {
            place = new Vec3(v.x(k), v.y(k), v.z(k));
            bsdf = v.bsdf(k);
            v.get(k, s);
            survival = v.survival(k);
            isInterface = bsdf.transmits();
            of = v;
            number = k;
        }

        /** A point of a light. */
        Vertex(Vec3 place) {
            this.place = place;
            bsdf = null;
            survival = 0;
            isInterface = false;
            of = null;
            number = 0;
        }

        double cosine(Vec3 d) {
            double cosine = d.x() * s.nx + d.y() * s.ny + d.z() * s.nz;
            return of == null ? Math.abs(cosine) : of.projected(number, cosine);
        }

        /** The density of going to one neighbour, coming from the other. */
        double density(Vec3 from, Vec3 to) {
            boolean other = from.x() * s.nx + from.y() * s.ny + from.z() * s.nz < 0;
            Scattering t = new Scattering();
            double sign = other ? -1 : 1;
            t.nx = sign * s.nx;
            t.ny = sign * s.ny;
            t.nz = sign * s.nz;
            t.ox = from.x();
            t.oy = from.y();
            t.oz = from.z();
            t.ix = to.x();
            t.iy = to.y();
            t.iz = to.z();
            t.red = s.red;
            t.green = s.green;
            t.blue = s.blue;
            t.eta = other ? 1 / s.eta : s.eta;
            return survival * bsdf.pdf(t);
        }
    }

    private static Vec3 at(PathVertices v, int k) {
        return new Vec3(v.x(k), v.y(k), v.z(k));
    }

    /** All vertices from the light to the first before the eye. */
    private List<Vertex> path(Vertex light, PathVertices l, int s, PathVertices e, int t) {
        List<Object> all = new ArrayList<>();
        all.add(light);
        for (int k = 0; k < s - 1; k++) {
            all.add(l.bsdf(k) == null ? new double[] {l.x(k), l.y(k), l.z(k), l.eta(k)} : new Vertex(l, k));
        }
        for (int k = t - 2; k >= 0; k--) {
            all.add(e.bsdf(k) == null ? new double[] {e.x(k), e.y(k), e.z(k), 1 / e.eta(k)} : new Vertex(e, k));
        }
        List<Vertex> path = new ArrayList<>();
        Vertex last = null;
        Vec3 before = null;
        for (Object o : all) {
            Vec3 here =
                    o instanceof Vertex v ? v.place : new Vec3(((double[]) o)[0], ((double[]) o)[1], ((double[]) o)[2]);
            if (o instanceof Vertex v) {
                if (before != null) {
                    v.toLight = before.minus(here).normalized();
                }
                path.add(v);
            } else {
                last.delta = true;
                // From the side of the light to that of the eye: the square of the index there over that here.
                last.expansion /= ((double[]) o)[3];
            }
            if (before != null && (last.toEye == null)) {
                last.toEye = here.minus(before).normalized();
            }
            before = here;
            last = o instanceof Vertex v ? v : last;
        }
        return path;
    }

    private double weight(Vertex light, int index, double cosine, PathVertices l, int s, PathVertices e, int t) {
        List<Vertex> p = path(light, l, s, e, t);
        int n = p.size();
        Vertex last = p.get(n - 1);
        boolean seenStraight = e.size() == 0 || e.bsdf(0) != null;
        last.toEye = null;
        double[] density = new double[n + 1];
        for (int j = 0; j <= n; j++) {
            density[j] = ofLight(p, j, index, cosine) * ofEye(p, j, seenStraight, e);
            // By area of the light.
            density[j] *= j == 0 ? Math.abs(cosine) : 1;
        }
        // The number of vertices before the connection, those of delta events not counted.
        int own = countUpTo(l, s);
        double sum = 0;
        for (double d : density) {
            sum += d / density[own] * (d / density[own]);
        }
        return 1 / sum;
    }

    private static int countUpTo(PathVertices l, int s) {
        int count = Math.min(s, 1);
        for (int k = 0; k < s - 1; k++) {
            count += l.bsdf(k) == null ? 0 : 1;
        }
        return count;
    }

    /** The density of the vertex b by area, for one of its direction at a: up to what is the same in both directions. */
    private static double toArea(Vertex a, Vertex b, boolean delta, double indices, double cosineAtB) {
        return delta ? indices * cosineAtB : cosineAtB / b.place.minus(a.place).dot(b.place.minus(a.place));
    }

    /** The density of the first j vertices as made from the light. */
    private double ofLight(List<Vertex> p, int j, int index, double cosine) {
        PhysicalLight light = scene.physical.lights[index];
        if (j == 0) {
            return light.isPoint ? 0 : 1;
        }
        Vertex first = p.get(0);
        if (j == 1) {
            return p.size() == 1 || first.delta ? 0 : aimed(light, index, cosine, first, p.get(1));
        }
        double outside = starts.shinesBothWays(index) ? Math.abs(cosine) : cosine;
        double density = starts.probability(index)
                * starts.pointDensity(index)
                * (light.isPoint ? starts.directionDensity(index, 0, 0, 1) : starts.directionDensity(index, outside));
        for (int k = 0; k < j - 1; k++) {
            Vertex a = p.get(k);
            Vertex b = p.get(k + 1);
            density *= toArea(a, b, a.delta, a.expansion, b.cosine(b.toLight));
            if (k + 2 < j) {
                density *= b.density(b.toLight, b.toEye);
            }
        }
        // The edge to what comes next is the connection.
        return p.get(j - 1).delta ? 0 : density;
    }

    private double aimed(PhysicalLight light, int index, double cosine, Vertex point, Vertex x) {
        double nx = x.isInterface ? 0 : x.s.nx;
        double ny = x.isInterface ? 0 : x.s.ny;
        double nz = x.isInterface ? 0 : x.s.nz;
        double probability =
                scene.physical.picker.probability(index, x.place.x(), x.place.y(), x.place.z(), nx, ny, nz, choice);
        if (light.isPoint) {
            return probability;
        }
        Vec3 d = point.place.minus(x.place);
        Vec3 u = d.normalized();
        light.form.aim(sample, x.place.x(), x.place.y(), x.place.z());
        return probability
                * light.form.pdf(sample, u.x(), u.y(), u.z(), d.length(), cosine)
                * Math.abs(cosine)
                / d.dot(d);
    }

    /** The density of all but the first j vertices as made from the eye. */
    private double ofEye(List<Vertex> p, int j, boolean seenStraight, PathVertices e) {
        int n = p.size();
        if (j == n) {
            // Connected to the eye itself; but not the light.
            return seenStraight && n > 1 ? BidirectionalTracer.LIGHT_PATHS_PER_SAMPLE : 0;
        }
        Vertex last = p.get(n - 1);
        double density = 1;
        if (seenStraight && n > 1) {
            Vec3 toEye = new Vec3(last.s.ox, last.s.oy, last.s.oz);
            if (e.size() == 0) {
                toEye = new Vec3(last.s.ix, last.s.iy, last.s.iz);
            }
            density = eye.importanceOf(last.place.x(), last.place.y(), last.place.z()) * last.cosine(toEye);
            last.toEye = toEye;
        } else if (n > 1) {
            // Its cosine is in all strategies.
            last.toEye = new Vec3(last.s.ox, last.s.oy, last.s.oz);
        }
        for (int k = n - 1; k > j; k--) {
            Vertex a = p.get(k);
            Vertex b = p.get(k - 1);
            double cosineAtB = k - 1 == 0 ? 1 : b.cosine(b.toEye);
            density *= a.density(a.toEye, a.toLight) * toArea(a, b, b.delta, 1, cosineAtB);
        }
        return density;
    }

    /** Checks what paths from both ends find. */
    private final class Checked implements Strategies {
        final BidirectionalTracer tracer;

        Checked(BidirectionalTracer tracer) {
            this.tracer = tracer;
        }

        @Override
        public double weight(int s, int t, double weight) {
            if (s == 0 && tracer.eye().isFirst()) {
                assertEquals(1, weight);
                return weight;
            }
            paths++;
            PathVertices l = tracer.light().vertices;
            PathVertices e = tracer.eye().vertices;
            double expected;
            if (s >= 2) {
                expected = ofLightPath(tracer.light(), l, s, e, t);
            } else if (s == 1) {
                LightSample to = tracer.lights().sample();
                Vec3 point = at(e, t - 2).plus(new Vec3(to.dx, to.dy, to.dz).times(to.length));
                expected = BidirectionalWeightsTest.this.weight(
                        new Vertex(point), tracer.lights().light(), to.cosine, l, 1, e, t);
            } else {
                expected = ofHit(l, e, t);
            }
            throughDelta += e.bsdf(0) == null ? 1 : 0;
            boolean isInMedium = false;
            for (int k = 0; k < t - 2 && e.bsdf(k) != null; k++) {
                isInMedium |= e.bsdf(k) instanceof HenyeyGreenstein;
            }
            inMedia += isInMedium ? 1 : 0;
            assertEquals(expected, weight, 1e-10 * (s + t), () -> "s = " + s + ", t = " + t);
            return weight;
        }

        private double ofHit(PathVertices l, PathVertices e, int t) {
            EyeSubpath path = tracer.eye();
            Vertex light = new Vertex(new Vec3(path.path.at.hit.px, path.path.at.hit.py, path.path.at.hit.pz));
            Scattering at = path.s;
            double cosine = path.path.at.hit.side * (at.ox * at.nx + at.oy * at.ny + at.oz * at.nz);
            int index = scene.physical.lightOf(path.path.at.id, path.path.at.hit.face);
            // Its last vertex is the light itself.
            return hit(light, index, cosine, l, e, t);
        }

        private double hit(Vertex light, int index, double cosine, PathVertices l, PathVertices e, int t) {
            double[] factor = {1};
            return weightOfHit(light, index, cosine, l, e, t - 1, factor);
        }
    }

    private double weightOfHit(
            Vertex light, int index, double cosine, PathVertices l, PathVertices e, int t, double[] factor) {
        List<Vertex> p = path(light, l, 1, e, t);
        boolean onlyDelta = p.size() == 1;
        if (onlyDelta) {
            return factor[0];
        }
        boolean seenStraight = e.bsdf(0) != null;
        double[] density = new double[p.size() + 1];
        for (int j = 0; j < density.length; j++) {
            density[j] = ofLight(p, j, index, cosine) * ofEye(p, j, seenStraight, e);
            if (j == 0) {
                // By area of the light.
                density[j] *= Math.abs(cosine);
            }
        }
        double sum = 0;
        for (double d : density) {
            sum += d / density[0] * (d / density[0]);
        }
        return 1 / sum;
    }

    private double ofLightPath(LightSubpath path, PathVertices l, int s, PathVertices e, int t) {
        Vertex light = new Vertex(new Vec3(path.startX, path.startY, path.startZ));
        return weight(light, path.source.light, path.source.cosineOutside(), l, s, e, t);
    }

    @ParameterizedTest
    @ValueSource(strings = {PERSPECTIVE, PARALLEL, PANORAMA})
    void theWeightsOfPathsFromBothEndsFollowFromAllDensities(String camera) {
        read(camera, false);
        checkPathsFromBothEnds(100_000);
        assertTrue(throughDelta > 1000, "few paths are seen in mirrors: " + throughDelta);
    }

    @Test
    void soTheyDoInMediaThatScatterLight() {
        read(PERSPECTIVE, true);
        checkPathsFromBothEnds(40_000);
        assertTrue(inMedia > 10_000, "few paths are scattered by media: " + inMedia);
    }

    private void checkPathsFromBothEnds(int most) {
        BidirectionalTracer tracer = new BidirectionalTracer(scene, new RayCounters(scene.kindNames.size()));
        tracer.watch(new Checked(tracer));
        SobolSampler sampler = new SobolSampler();
        Ray ray = new Ray();
        double[] color = new double[3];
        tracer.beginTile(0, 0, 1, 1);
        for (int k = 0; paths < most; k++) {
            sampler.pixel(5, k % SIDE, k / SIDE % SIDE);
            sampler.sample(k / (SIDE * SIDE));
            scene.camera.ray((k % SIDE + sampler.filmX()) / SIDE, (k / SIDE % SIDE + sampler.filmY()) / SIDE, ray);
            tracer.shade(ray, sampler, color);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {PERSPECTIVE, PARALLEL, PANORAMA})
    void theWeightsOfPathsToTheEyeItselfFollowFromAllDensities(String camera) {
        read(camera, false);
        checkPathsToTheEye();
    }

    @Test
    void soDoThoseOfPathsToTheEyeItselfInMediaThatScatterLight() {
        read(PERSPECTIVE, true);
        checkPathsToTheEye();
    }

    private void checkPathsToTheEye() {
        BidirectionalLightTracer tracer =
                new BidirectionalLightTracer(scene, 7, SIDE, SIDE, new RayCounters(scene.kindNames.size()));
        PathVertices none = new PathVertices();
        tracer.watch((s, t, weight) -> {
            paths++;
            LightSubpath path = tracer.light();
            Vertex light = new Vertex(new Vec3(path.startX, path.startY, path.startZ));
            List<Vertex> p = path(light, path.vertices, s, none, 1);
            p.get(p.size() - 1).s.ix = path.s.ix;
            p.get(p.size() - 1).s.iy = path.s.iy;
            p.get(p.size() - 1).s.iz = path.s.iz;
            near += nearest(p) > NEAR ? 0 : 1;
            double[] density = new double[p.size() + 1];
            double sum = 0;
            for (int j = density.length - 1; j >= 0; j--) {
                density[j] = ofEye(p, j, true, none);
                density[j] *= ofLight(p, j, path.source.light, path.source.cosineOutside());
                density[j] *= j == 0 ? Math.abs(path.source.cosineOutside()) : 1;
                sum += density[j] / density[p.size()] * (density[j] / density[p.size()]);
            }
            // Directions are found again from places, whose rounding counts over the distance between them, and more at
            // grazing angles.
            if (nearest(p) > NEAR) {
                assertEquals(1 / sum, weight, 1e-10 * (s + 1), () -> "s = " + s);
            }
            return weight;
        });
        SplatBatch batch =
                new SplatBatch(0, 0, SIDE, SIDE, SplatScale.of(tracer.meanContribution(1000), 1 << 20, SIDE * SIDE));
        batch.begin(1 << 20);
        for (int k = 0; paths < 50_000; k++) {
            tracer.trace(k, batch);
        }
        assertTrue(near < 100, "many paths are not compared: " + near);
    }

    private static double nearest(List<Vertex> path) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int k = 1; k < path.size(); k++) {
            nearest = Math.min(
                    nearest, path.get(k).place.minus(path.get(k - 1).place).length());
        }
        return nearest;
    }
}
