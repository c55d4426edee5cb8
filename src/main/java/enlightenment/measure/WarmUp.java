package enlightenment.measure;

import enlightenment.measure.analysis.Configuration;

/** Renders without counting until Java has compiled the code, so that the first measured run does not pay for it. */
final class WarmUp {
    /** Least number of samples per pixel; more for methods that are replaced by another below their own least. */
    private static final double SAMPLES = 4;

    /** Largest share of the budget, limited to {@link #MAX_SECONDS}. Measured: fire and ice needs three to four seconds. */
    private static final double SHARE = 0.08;

    private static final double MAX_SECONDS = 6;
    private static final int MIN_ROUNDS = 2;

    private WarmUp() {}

    /** Warms up; returns the seconds by which the first render of the first method exceeded the last, at least 0. */
    static double run(Session session) {
        session.say("warming up");
        double limit = Math.min(SHARE * session.settings.budgetSeconds(), MAX_SECONDS);
        double first = 0;
        double last = 0;
        long seed = session.settings.base().seed();
        for (int round = 0; round < MIN_ROUNDS || session.elapsed() < limit; round++) {
            for (String method : session.settings.methods()) {
                double samples = Math.max(SAMPLES, Math.ceil(session.fewest(method)));
                double wall = session.timed(Configuration.ofScene(session.settings, method), samples, seed)
                        .wall();
                if (method.equals(session.settings.methods().get(0))) {
                    first = round == 0 ? wall : first;
                    last = wall;
                }
            }
        }
        return Math.max(first - last, 0);
    }
}
