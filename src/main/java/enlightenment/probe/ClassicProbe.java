package enlightenment.probe;

import enlightenment.classic.shading.LightSamples;
import enlightenment.classic.shading.PathReport;
import enlightenment.film.SampleLog;
import enlightenment.primitive.Ray;
import enlightenment.sampling.SobolSampler;
import enlightenment.world.CompiledScene;

/**
 * Of classic shading: S and L are those of a light sample that was taken for the colour; where several were, sample n of a pixel tells of
 * number n modulo how many they are.
 */
final class ClassicProbe extends RayProbe {
    private final PathReport report;

    /** @param report of the shader, which {@linkplain PathReport#keepRays keeps rays} */
    ClassicProbe(CompiledScene scene, PathReport report) {
        super(scene, scene.classic.maxBounces());
        this.report = report;
    }

    @Override
    void tell(SobolSampler sampler) {
        LightSamples rays = report.rays;
        if (rays.size() == 0) {
            follow(sampler);
            return;
        }
        int k = sampler.sample() % rays.size();
        bounces = rays.bounce(k);
        outcome = rays.isBlocked(k) ? SampleLog.Outcome.SHADOWED : SampleLog.Outcome.LIT;
        int s = PathReport.SURFACE_POINT;
        surfaceIsAt(rays.number(k, s), rays.number(k, s + 1), rays.number(k, s + 2));
        int l = PathReport.LIGHT_POINT;
        lightIsAt(rays.number(k, l), rays.number(k, l + 1), rays.number(k, l + 2));
    }

    @Override
    boolean cross(Ray at, SobolSampler sampler) {
        path.cross(at);
        return true;
    }
}
