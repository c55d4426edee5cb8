package enlightenment.classic.shading;

import enlightenment.color.DisplayRgb;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;
import enlightenment.transport.ray.PathFollower;
import enlightenment.transport.ray.Shader;
import enlightenment.world.CompiledScene;
import enlightenment.world.material.SurfaceMaterial;
import enlightenment.world.parts.RayCounters;
import java.util.function.BooleanSupplier;

/**
 * The paper's cosine shading: the colour seen along one camera ray, display-referred.
 *
 * <p>With c the surface colour, cosθ (0..1) between the normal that faces the viewer and the direction to a light point,
 * and k the share of direct light that an occluded point keeps: colour = c · light · (ambient + (1 − ambient) · mean over
 * light points of (visible ? 1 : k) · cosθ), averaged over the lights. Mirrors and glass multiply their colour and are
 * followed; everything but a light occludes. See docs/notes/classic-shading.md.
 *
 * <p>{@code step} and {@link ClassicDirectLight}'s {@code meanCosine} are longer than our methods usually are: the just-in-time compiler
 * does not inline a method of more than 325 bytes of code, and these boundaries keep it from compiling the whole renderer once at each
 * level of calls. Without the first, renders of a few seconds take a seventh more CPU time (docs/notes/benchmarks.md).
 */
public final class ClassicShader implements Shader {
    private final CompiledScene scene;
    private final PathReport report = new PathReport();
    private final PathFollower path;
    private final ClassicDirectLight direct;
    private final double[] surface = new double[3];

    private double throughputR;
    private double throughputG;
    private double throughputB;
    private double red;
    private double green;
    private double blue;

    /**
     * A shader for one thread.
     *
     * @param scene what is seen
     * @param lightPoints the number of points of each light at each hit
     * @param counters what this thread counts
     */
    public ClassicShader(CompiledScene scene, int lightPoints, RayCounters counters) {
        this.scene = scene;
        path = new PathFollower(scene, counters, scene.classic.maxBounces());
        direct = new ClassicDirectLight(scene, lightPoints, counters, path, report);
    }

    /**
     * A shader for callers that read colours only, not the {@link #report}. It takes the cheapest way to equal colours.
     *
     * @param scene what is seen
     * @param lightPoints the number of points of each light at each hit
     * @param counters what this thread counts
     */
    public static ClassicShader ofColors(CompiledScene scene, int lightPoints, RayCounters counters) {
        ClassicShader shader = new ClassicShader(scene, lightPoints, counters);
        shader.path.tracer.leaveVisibilityOpen();
        shader.report.stayEmpty();
        return shader;
    }

    @Override
    public void beginTile(double x0, double y0, double x1, double y1) {
        path.tracer.beginTile(x0, y0, x1, y1);
    }

    @Override
    public boolean seesNothing() {
        return path.tracer.seesNothing();
    }

    @Override
    public void stopWhen(BooleanSupplier condition) {
        path.poll.stopWhen(condition);
    }

    /** Sets the number of points of each light at each hit. */
    public void lightPoints(int count) {
        direct.lightPoints(count);
    }

    /** Sets the guide that samples lights that may be partly occluded; null for low-discrepancy samples. */
    public void guide(LightGuide chooser) {
        direct.guide(chooser);
    }

    /** What is known of the last path; the same object for all of them. Empty for a shader {@link #ofColors}. */
    public PathReport report() {
        return report;
    }

    @Override
    public void shade(Ray ray, Sampler sampler, double[] out) {
        red = 0;
        green = 0;
        blue = 0;
        throughputR = 1;
        throughputG = 1;
        throughputB = 1;
        if (report.isRead()) {
            report.clear();
        }
        path.begin(ray);
        boolean continues = true;
        while (continues) {
            continues = step(ray, sampler) && path.continues();
        }
        if (report.isRead()) {
            report.pathKey = path.key;
        }
        out[0] = red;
        out[1] = green;
        out[2] = blue;
    }

    /** Follows the ray to the next event; returns whether the path continues. */
    private boolean step(Ray ray, Sampler sampler) {
        PathFollower.Event event = path.next(ray);
        if (event == PathFollower.Event.NOTHING) {
            DisplayRgb background = scene.classic.background();
            add(background.r(), background.g(), background.b());
            return false;
        }
        if (event == PathFollower.Event.LIGHT) {
            add(path.light.r, path.light.g, path.light.b);
            return false;
        }
        if (event == PathFollower.Event.SURFACE) {
            SurfaceMaterial material = path.at.material;
            path.color(material, surface);
            if (!material.isDelta) {
                shadeSurface(material, sampler, 1);
                return false;
            }
            path.scatter(ray, material, surface, 0, 0, 0);
            filter(1);
        } else {
            boolean through = path.cross(ray);
            for (int k = 0; k < path.glass.surfaces(); k++) {
                if (!path.glass.filters(k, through)) {
                    continue;
                }
                path.turnTo(k);
                SurfaceMaterial material = path.at.material;
                path.color(material, surface);
                if (material.transparency < 1) {
                    shadeSurface(material, sampler, 1 - material.transparency);
                }
                if (through) {
                    filter(material.transparency);
                } else {
                    throughputR *= material.transparency;
                    throughputG *= material.transparency;
                    throughputB *= material.transparency;
                }
            }
        }
        return throughputR > 0 || throughputG > 0 || throughputB > 0;
    }

    private void add(double r, double g, double b) {
        red = Math.fma(throughputR, r, red);
        green = Math.fma(throughputG, g, green);
        blue = Math.fma(throughputB, b, blue);
    }

    private void filter(double share) {
        throughputR *= surface[0] * share;
        throughputG *= surface[1] * share;
        throughputB *= surface[2] * share;
    }

    /** Adds the light that the surface itself reflects, times a share. */
    private void shadeSurface(SurfaceMaterial material, Sampler sampler, double share) {
        int lights = scene.lights.length;
        if (lights == 0) {
            double factor = scene.classic.ambient() * share;
            add(surface[0] * factor, surface[1] * factor, surface[2] * factor);
            return;
        }
        if (report.isRead()) {
            direct.weigh(throughputR * surface[0], throughputG * surface[1], throughputB * surface[2], share);
        }
        direct.gather(material.receivesShadows, sampler);
        // Divided last: n white lights on white give exactly white, whatever n is.
        double n = lights;
        add(
                surface[0] * (direct.red * share) / n,
                surface[1] * (direct.green * share) / n,
                surface[2] * (direct.blue * share) / n);
    }
}
