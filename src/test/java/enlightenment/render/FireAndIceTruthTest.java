package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Pixels of fire and ice against an independent brute-force evaluation of the shading formula: textbook intersections, a
 * fine grid over the pixel and over the cone that the light fills, nothing shared with the renderer.
 */
class FireAndIceTruthTest {
    private static final double[][] SPHERES = {{-2, 1, 4, 1.5}, {2, 1, 4, 1.5}, {0, 3, 4, 0.75}};
    private static final double[] LIGHT = {0, 1, 1};
    private static final double LIGHT_RADIUS = 0.15;
    private static final int PIXEL_GRID = 12;
    private static final int CONE_GRID = 24;

    @ParameterizedTest(name = "pixel ({0}, {1}), {2}")
    @CsvSource({
        "400, 340, lit back wall",
        "250, 330, ice sphere from the front",
        "560, 200, fire sphere",
        "230, 140, back wall in the umbra of ice",
        "130, 125, penumbra on the left wall",
        "183, 122, penumbra across the corner",
        "337, 120, penumbra of the mirror sphere",
        "708, 240, penumbra on the right wall",
        "400, 20, ceiling without shadows",
        "90, 260, left wall at the edge of the shadow",
        "400, 266, the light itself"
    })
    void aPixelShowsTheMeanOfTheShadingFormulaOverPixelAndLight(int x, int y, String what) {
        Scene scene = TestScenes.whiteFireAndIce().build();
        RenderSettings settings = RenderSettings.of(scene)
                .withAntialias(16)
                .with(new BuiltInMethod.RayTraceSettings(16))
                .withCrop(new RenderSettings.Crop(x, y, 1, 1));
        Image image = Renderer.render(scene, settings);
        double truth = bruteForce(x, y);
        assertEquals(truth, image.component(0, 0, 0), 0.002, what);
        assertEquals(truth, image.component(0, 0, 2), 0.002, what);
    }

    private static double bruteForce(int x, int y) {
        double sum = 0;
        for (int i = 0; i < PIXEL_GRID; i++) {
            for (int j = 0; j < PIXEL_GRID; j++) {
                double px = -3 + 6 * (x + (i + 0.5) / PIXEL_GRID) / 800;
                double py = 3 - 3 * (y + (j + 0.5) / PIXEL_GRID) / 400;
                sum += seen(new double[] {0, 1, -3}, new double[] {px, py - 1, 3});
            }
        }
        return sum / (PIXEL_GRID * PIXEL_GRID);
    }

    /** The colour seen from o along d, both plain white scenes have; the mirror sphere is not followed here. */
    private static double seen(double[] o, double[] d) {
        double best = Double.POSITIVE_INFINITY;
        double[] normal = null;
        boolean ceiling = false;
        for (double[] s : SPHERES) {
            double t = sphere(o, d, s, s[3]);
            if (t < best) {
                best = t;
                double[] p = at(o, d, t);
                normal = new double[] {(p[0] - s[0]) / s[3], (p[1] - s[1]) / s[3], (p[2] - s[2]) / s[3]};
                ceiling = false;
            }
        }
        double[][] walls = {{2, 8}, {0, 6}, {0, -6}, {1, -6}, {1, 6}};
        for (double[] wall : walls) {
            int axis = (int) wall[0];
            double t = (wall[1] - o[axis]) / d[axis];
            if (t > 0 && t < best) {
                best = t;
                normal = new double[3];
                normal[axis] = -Math.signum(wall[1]);
                ceiling = axis == 1 && wall[1] == 6;
            }
        }
        if (sphere(o, d, LIGHT, LIGHT_RADIUS) < best) {
            return 1;
        }
        return shade(at(o, d, best), normal, ceiling);
    }

    private static double shade(double[] p, double[] n, boolean ceiling) {
        double[] w = {LIGHT[0] - p[0], LIGHT[1] - p[1], LIGHT[2] - p[2]};
        double dist = Math.sqrt(dot(w, w));
        double[] axis = {w[0] / dist, w[1] / dist, w[2] / dist};
        double[] helper = Math.abs(axis[0]) < 0.5 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
        double[] a = cross(axis, helper);
        double la = Math.sqrt(dot(a, a));
        a = new double[] {a[0] / la, a[1] / la, a[2] / la};
        double[] b = cross(axis, a);
        double cosMax = Math.sqrt(1 - LIGHT_RADIUS * LIGHT_RADIUS / (dist * dist));
        double sum = 0;
        for (int i = 0; i < CONE_GRID; i++) {
            for (int j = 0; j < CONE_GRID; j++) {
                double cos = 1 - (i + 0.5) / CONE_GRID * (1 - cosMax);
                double sin = Math.sqrt(1 - cos * cos);
                double phi = 2 * Math.PI * (j + 0.5) / CONE_GRID;
                double[] l = new double[3];
                for (int k = 0; k < 3; k++) {
                    l[k] = cos * axis[k] + sin * (Math.cos(phi) * a[k] + Math.sin(phi) * b[k]);
                }
                double cosine = Math.max(dot(n, l), 0);
                sum += cosine * (ceiling || !blocked(p, l, dist) ? 1 : 0.5);
            }
        }
        return 0.5 + 0.5 * sum / (CONE_GRID * CONE_GRID);
    }

    private static boolean blocked(double[] p, double[] l, double dist) {
        for (double[] s : SPHERES) {
            double[] m = {p[0] - s[0], p[1] - s[1], p[2] - s[2]};
            boolean self = Math.abs(Math.sqrt(dot(m, m)) - s[3]) < 1e-9;
            double t = self ? Double.POSITIVE_INFINITY : sphere(p, l, s, s[3]);
            if (t < dist - LIGHT_RADIUS) {
                return true;
            }
        }
        return false;
    }

    private static double sphere(double[] o, double[] d, double[] c, double r) {
        double[] f = {o[0] - c[0], o[1] - c[1], o[2] - c[2]};
        double a = dot(d, d);
        double b = 2 * dot(f, d);
        double q = b * b - 4 * a * (dot(f, f) - r * r);
        double t = (-b - Math.sqrt(q)) / (2 * a);
        return q > 0 && t > 0 ? t : Double.POSITIVE_INFINITY;
    }

    private static double[] at(double[] o, double[] d, double t) {
        return new double[] {o[0] + t * d[0], o[1] + t * d[1], o[2] + t * d[2]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
}
