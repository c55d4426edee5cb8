package enlightenment.measure;

/**
 * Renders for nothing until Java has compiled what there is to compile, so that the first run that counts is not the one that
 * pays for it.
 */
final class WarmUp {
    private static final double SAMPLES = 4;

    /** The share of the budget, and the seconds, after which it is over; measured: fire and ice needs three to four. */
    private static final double SHARE = 0.08;

    private static final double LONGEST = 6;
    private static final int LEAST_ROUNDS = 2;

    private WarmUp() {}

    /** Returns by how many seconds the very first render took longer than the same one now. */
    static double run(Session session) {
        session.say("warming up");
        double limit = Math.min(SHARE * session.settings.budgetSeconds(), LONGEST);
        double first = 0;
        double last = 0;
        long seed = session.settings.base().seed();
        for (int round = 0; round < LEAST_ROUNDS || session.elapsed() < limit; round++) {
            for (String method : session.settings.methods()) {
                double wall = session.timed(session.settings.own(method), SAMPLES, seed)
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
