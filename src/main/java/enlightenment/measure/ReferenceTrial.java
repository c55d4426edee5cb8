package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Tries what the reference may be rendered by, and chooses what has the least error for its time: where light is hard to find, a method
 * that hardly finds it would give no reference at all. All that is tried sees the whole scene and is unbiased.
 */
final class ReferenceTrial {
    /** Least number of samples per pixel; more for methods that are replaced by another below their own least. */
    private static final double SAMPLES = 16;

    /** Small budgets include fixed costs, and Java may still be compiling: more trials than one, where there is time. */
    private static final int RENDERS = 3;

    /** Up to this ratio of squared error times time the second best makes one of the parts: two methods are a check of each other. */
    private static final double CLOSE = 2;

    /**
     * Light samples per hit of a part by a method that takes a fixed number of them, unless the scene asks for fewer: many camera rays with
     * few light samples each converge sooner. Fitted: 2 took 0.6 to 0.8 of the time to equal error of 10 and 25.
     */
    private static final int LIGHT_SAMPLES = 2;

    private final Session session;

    ReferenceTrial(Session session) {
        this.session = session;
    }

    /** How good something is: its squared error times its time. */
    private record Tried(Configuration configuration, double cost) {}

    /**
     * The configurations of the parts: the best one twice, or the best two if they are close.
     *
     * @param seconds what the trials may take together, but that each configuration is tried once
     */
    List<Configuration> run(double seconds) {
        List<Configuration> candidates = candidates(session).stream()
                .map(word -> configuration(session, word))
                .toList();
        List<Tried> tried = new ArrayList<>();
        for (Configuration candidate : candidates) {
            session.say("trying " + candidate.name() + " for the reference");
            tried.add(new Tried(candidate, cost(candidate, seconds / candidates.size())));
        }
        return chosen(tried);
    }

    private static List<Configuration> chosen(List<Tried> tried) {
        // Stable: among equals the first one wins.
        List<Tried> sorted =
                tried.stream().sorted(Comparator.comparingDouble(Tried::cost)).toList();
        Tried best = sorted.get(0);
        Tried second = sorted.size() > 1 && sorted.get(1).cost <= CLOSE * best.cost ? sorted.get(1) : best;
        return List.of(best.configuration, second.configuration);
    }

    /**
     * The words of the methods that may be tried: those compared that are the program's own and see all of the scene; of methods from
     * outside it is not known what they show, so that they are tried only among themselves. Where nothing is left, path tracing.
     */
    static List<String> candidates(Session session) {
        List<String> own = new ArrayList<>();
        List<String> others = new ArrayList<>();
        for (String word : session.settings.methods()) {
            if (!(Method.named(word) instanceof BuiltInMethod)) {
                others.add(word);
            } else if (!session.blind.contains(word)) {
                own.add(word);
            }
        }
        boolean onlyOthers = others.size() == session.settings.methods().size();
        return !own.isEmpty() ? own : onlyOthers ? others : List.of(Method.RAYTRACE.word());
    }

    private static Configuration configuration(Session session, String method) {
        Configuration own = Configuration.ofScene(session.settings, method);
        boolean fewer = !Configuration.variants(own).isEmpty() && LIGHT_SAMPLES < own.lightSamples();
        return fewer ? new Configuration(method, LIGHT_SAMPLES, false) : own;
    }

    private double cost(Configuration candidate, double seconds) {
        double samples = Math.max(SAMPLES, Math.ceil(session.fewest(candidate.method())));
        long seed = session.settings.base().seed();
        double cost = 0;
        for (int k = 0; k < RENDERS && (k == 0 || session.expected(candidate, samples) < seconds / RENDERS); k++) {
            TimedRenderer.Timed render = session.timed(candidate, samples, seed - 1 - ReferenceMaker.PARTS - k);
            double error = render.sampling().estimatedError();
            cost = error * error * render.wall();
        }
        return cost;
    }
}
