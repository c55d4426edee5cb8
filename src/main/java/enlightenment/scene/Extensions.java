package enlightenment.scene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;

/** The methods from outside, looked for when this class is first needed: a start without them must not pay for the search. */
final class Extensions {
    /**
     * What came of the search.
     *
     * @param fault why they cannot be used, or null; told each time somebody asks, as a class is initialised only once
     */
    private record Search(List<Method> found, Throwable fault) {}

    private static final Search SEARCH = search();

    private Extensions() {}

    /**
     * The methods found as services, sorted by their words, as services come in no fixed order.
     *
     * @throws IllegalStateException if one cannot be made, or two of them conflict ({@link #requireDistinct})
     */
    static List<Method> found() {
        Throwable fault = SEARCH.fault();
        if (fault != null) {
            throw new IllegalStateException("the methods from outside cannot be used: " + fault.getMessage(), fault);
        }
        return SEARCH.found();
    }

    private static Search search() {
        try {
            List<Method> all = new ArrayList<>(Method.selectable(BuiltInMethod.ALL));
            List<Method> sorted = new ArrayList<>();
            ServiceLoader.load(MethodExtension.class).forEach(sorted::add);
            sorted.sort(Comparator.comparing(Method::word));
            for (Method method : sorted) {
                all.forEach(other -> requireDistinct(method, other));
                all.add(method);
            }
            return new Search(List.copyOf(sorted), null);
        } catch (ServiceConfigurationError | RuntimeException e) {
            return new Search(List.of(), e);
        }
    }

    /** Throws where two methods have the same word or use a key differently, since choosing one silently would hide that. */
    static void requireDistinct(Method method, Method other) {
        if (method.word().equals(other.word())) {
            throw new IllegalStateException("there are two methods called " + method.word() + ": "
                    + method.getClass().getName() + " and " + other.getClass().getName());
        }
        for (Method.Setting mine : method.settings()) {
            for (Method.Setting theirs : other.settings()) {
                if (mine.key().equals(theirs.key()) && !mine.equals(theirs)) {
                    throw new IllegalStateException("the methods " + method.word() + " and " + other.word()
                            + " mean different things by the setting " + mine.key());
                }
            }
        }
    }
}
