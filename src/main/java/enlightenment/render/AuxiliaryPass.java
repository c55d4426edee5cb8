package enlightenment.render;

import enlightenment.image.Image;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Ray;
import enlightenment.scene.RenderSettings;
import enlightenment.work.Workers;
import enlightenment.world.CompiledScene;
import enlightenment.world.Tracer;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.parts.RayCounters;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;

/** One ray through the middle of each pixel, for what it meets first. */
final class AuxiliaryPass {
    private final CompiledScene scene;
    private final RenderSettings settings;
    private final RenderSettings.Crop region;

    /** The frame's origin in the scene. */
    private final Vec3 origin;

    private final Map<RenderResult.Auxiliary, float[]> numbers = new EnumMap<>(RenderResult.Auxiliary.class);

    AuxiliaryPass(CompiledScene scene, RenderSettings settings, Set<RenderResult.Auxiliary> kinds) {
        this.scene = scene;
        this.settings = settings;
        region = settings.region();
        origin = scene.frame.origin().toVec3();
        for (RenderResult.Auxiliary a : kinds) {
            if (a.needsRays()) {
                float[] all = new float[3 * region.width() * region.height()];
                Arrays.fill(
                        all,
                        a == RenderResult.Auxiliary.DEPTH
                                ? Float.POSITIVE_INFINITY
                                : a == RenderResult.Auxiliary.OBJECT ? -1 : 0);
                numbers.put(a, all);
            }
        }
    }

    /** Traces all rays, unless it is cancelled. */
    void run(BooleanSupplier cancelled) {
        if (!numbers.isEmpty()) {
            Workers.run(settings.threads(), region.height(), cancelled, () -> new Row()::trace);
        }
    }

    /** The images, by what they tell. */
    Map<RenderResult.Auxiliary, Image> images() {
        Map<RenderResult.Auxiliary, Image> images = new EnumMap<>(RenderResult.Auxiliary.class);
        numbers.forEach((a, all) -> images.put(a, new Image(region.width(), region.height(), all)));
        return images;
    }

    /** The working memory of one thread. */
    private final class Row {
        // These rays are no part of the picture, nor of what its report counts.
        private final Tracer tracer = new Tracer(scene, new RayCounters(scene.kindNames.size()));
        private final Ray ray = new Ray();
        private final Hit hit = new Hit();

        void trace(int row) {
            double filmY = (region.y() + row + 0.5) / settings.height();
            for (int column = 0; column < region.width(); column++) {
                scene.camera.ray((region.x() + column + 0.5) / settings.width(), filmY, ray);
                if (tracer.trace(ray, hit)) {
                    int object = tracer.light == null ? scene.object[tracer.id] : meetLight(tracer.light);
                    put(3 * (row * region.width() + column), object);
                }
            }
        }

        private int meetLight(ClassicLight light) {
            light.surface.complete(ray, light.surface.nearest(ray, Double.MAX_VALUE), hit);
            return scene.objects + Arrays.asList(scene.lights).indexOf(light);
        }

        private void put(int k, int object) {
            float[] depth = numbers.get(RenderResult.Auxiliary.DEPTH);
            if (depth != null) {
                Arrays.fill(depth, k, k + 3, depth());
            }
            float[] normal = numbers.get(RenderResult.Auxiliary.NORMAL);
            if (normal != null) {
                normal[k] = (float) (hit.side * hit.nx);
                normal[k + 1] = (float) (hit.side * hit.ny);
                normal[k + 2] = (float) (hit.side * hit.nz);
            }
            float[] position = numbers.get(RenderResult.Auxiliary.POSITION);
            if (position != null) {
                position[k] = coordinate(origin.x(), hit.px);
                position[k + 1] = coordinate(origin.y(), hit.py);
                position[k + 2] = coordinate(origin.z(), hit.pz);
            }
            float[] objects = numbers.get(RenderResult.Auxiliary.OBJECT);
            if (objects != null) {
                Arrays.fill(objects, k, k + 3, object);
            }
        }

        /** A coordinate of the scene, from one of the frame. */
        private float coordinate(double ofOrigin, double inFrame) {
            return finite(ofOrigin + Scale.scalb(inFrame, scene.frame.exponent()));
        }

        private static float finite(double value) {
            return (float) Math.max(Math.min(value, Float.MAX_VALUE), -Float.MAX_VALUE);
        }

        private float depth() {
            double along = (hit.px - ray.ox) * ray.dx + (hit.py - ray.oy) * ray.dy + (hit.pz - ray.oz) * ray.dz;
            double length = Math.sqrt(ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz);
            double depth = Scale.scalb(along / length, scene.frame.exponent());
            // Infinity is kept for what is not there.
            return finite(depth);
        }
    }
}
