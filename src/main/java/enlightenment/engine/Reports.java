package enlightenment.engine;

import enlightenment.color.Color;
import enlightenment.film.ErrorEstimate;
import enlightenment.plan.RenderPlan;
import enlightenment.report.RenderReport;
import enlightenment.work.Phases;
import enlightenment.work.RayCounts;
import enlightenment.world.parts.RayCounters;
import java.util.List;
import java.util.Optional;

/** Makes the reports of renders, wherever their units were rendered. */
public final class Reports {
    private Reports() {}

    /**
     * The report of a picture.
     *
     * @param counted what all threads or units counted
     * @param surveyRays camera rays that the film does not know of
     * @param rounding the error of rounding the picture to the depth of its file
     * @param round how often the picture was rendered
     */
    public static RenderReport of(
            RenderOutline outline,
            PictureFilm film,
            RayCounters counted,
            long surveyRays,
            Phases phases,
            double rounding,
            int round,
            long peakMemory) {
        return new RenderReport(
                outline.sceneName(),
                outline.settings(),
                outline.features(),
                RayCounts.raysByKind(counted),
                counted.lightSamples,
                counted.lightSamplesWithoutRay,
                sampling(outline, film, counted, surveyRays, rounding, round),
                RayCounts.byPrimitive(outline.kinds(), counted.tests),
                RayCounts.byPrimitive(outline.kinds(), counted.hits),
                counted.textureLookups,
                phases(phases),
                film.finishedPixels(),
                peakMemory);
    }

    /** The times of the phases. */
    public static List<RenderReport.Phase> phases(Phases phases) {
        return phases.list().stream()
                .map(t -> new RenderReport.Phase(t.name(), t.wallSeconds(), t.cpuSeconds()))
                .toList();
    }

    private static RenderReport.Sampling sampling(
            RenderOutline outline, PictureFilm film, RayCounters counted, long surveyRays, double rounding, int round) {
        RenderPlan plan = outline.plan();
        ErrorEstimate error = film.error();
        return new RenderReport.Sampling(
                plan.method(),
                plan.decidedBy(),
                plan.samples(),
                (film.cameraSamples() + surveyRays) / (double) Math.max(film.finishedPixels(), 1),
                error.rmse(),
                error.low(),
                error.high(),
                counted.clusters,
                counted.proposals,
                counted.accepted,
                rounding,
                round,
                light(outline, film, error));
    }

    private static Optional<RenderReport.Light> light(RenderOutline outline, PictureFilm film, ErrorEstimate error) {
        if (film.encoding() == Color.Encoding.DISPLAY) {
            return Optional.empty();
        }
        return Optional.of(error.linear()
                .map(e -> new RenderReport.Light(
                        e.relative(), e.kurtosis(), e.hasHeavyTail(), film.lostSamples(), outline.undersampled()))
                .orElse(new RenderReport.Light(
                        Double.NaN, Double.NaN, false, film.lostSamples(), outline.undersampled())));
    }
}
