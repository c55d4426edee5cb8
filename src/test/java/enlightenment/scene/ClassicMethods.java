package enlightenment.scene;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import java.util.List;
import org.junit.jupiter.params.provider.MethodSource;

/** Gives a parameterized test each of our methods that can render classic shading. */
@Target(ElementType.METHOD)
@Retention(RetentionPolicy.RUNTIME)
@MethodSource("enlightenment.scene.ClassicMethods$Source#all")
public @interface ClassicMethods {
    /** Where they come from. */
    final class Source {
        private Source() {}

        static List<BuiltInMethod> all() {
            return BuiltInMethod.rendering(Shading.Model.CLASSIC);
        }
    }
}
