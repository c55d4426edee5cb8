package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Trial of configurations for the reference, which selects those of least error for their time. A method that hardly samples difficult light gives
 * no reference. Only unbiased methods that sample all light of the scene are tried.
 */
final class ReferenceTrial {
    /** Least number of samples per pixel; more for methods that are replaced by another below their own least. */
    private static final double SAMPLES = 16;

    /** Number of trials of each method as time allows: small budgets include fixed costs, and Java may still be compiling. */
    private static final int RENDERS = 3;

    /** Largest ratio of costs at which the second best renders one of the parts: two methods check each other. */
    private static final double CLOSE = 2;

    /**
     * Light samples per hit of a part by a method with a fixed number, unless the scene has fewer. Many camera rays with few light samples each
     * converge sooner. Fitted: 2 took 0.6 to 0.8 of the time to equal error of 10 and 25.
     */
    private static final int LIGHT_SAMPLES = 2;

    private final Session session;

    ReferenceTrial(Session session) {
        this.session = session;
    }

    /** A configuration with its cost, the squared error times the time. */
    private record Tried(Configuration configuration, double cost) {}

    /**
     * The configurations of the parts: the best one twice, or the best two if they are close.
     *
     * @param seconds time limit of all trials together; each configuration is tried at least once
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
        // A stable sort: the first of equal ones wins.
        List<Tried> sorted =
                tried.stream().sorted(Comparator.comparingDouble(Tried::cost)).toList();
        Tried best = sorted.get(0);
        Tried second = sorted.size() > 1 && sorted.get(1).cost <= CLOSE * best.cost ? sorted.get(1) : best;
        return List.of(best.configuration, second.configuration);
    }

    /**
     * Words of the methods to try: the compared built-in ones that sample all light of the scene. Extensions, whose limitations are unknown, are
     * tried only if there are no built-in ones; path tracing if there is none at all.
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
