package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.fitting.minimal.CapsuleDescent;
    import starlogo.geometry.ConvexHull;
    import starlogo.geometry.Trigonometry;

    /**
     * Finds a bounding capsule that is close to the smallest one in any direction (not in the thesis). No practical exact algorithm is
     * known. There is no proof, but the capsule is within 0.1 % of the best capsules that long searches found for the models and point
     * sets of the project's tests.
     *
     * <p>It tries directions all around. For each one, it projects the hull's corners along the direction, puts the capsule's axis
     * through the smallest circle around them, and takes the best of several radii. Then it takes the best capsules and moves their ends
     * as long as the volume shrinks. The smallest sphere is a candidate too. It is a capsule whose ends are one point.</p>
     *
     * <p>The cost in Ruffle is 0.1 seconds for ten corners of the hull, and two to three seconds for 500. All of it is one step, even while a
     * ModelLoader loads the model, so a running game waits. Fit models with many corners before the game, for example with cooked models.</p>
     */
    public final class MinimalCapsuleFitter extends Fitter
    {
        private static const DIRECTIONS:int = 60;
        private static const APART:Number = 0.15;
        private var _sphereFitter:Fitter = new MinimalSphereFitter();

        /** Creates a fitter of capsules that are close to the smallest. */
        public function MinimalCapsuleFitter()
        {
            super("minimal capsule");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var sphere:Sphere = _sphereFitter.fitOnce(session) as Sphere;
            var around:Capsule = new Capsule(sphere.center, sphere.center, sphere.radius);
            var descent:CapsuleDescent = new CapsuleDescent(session.vertices, session.hull.points, around);
            descent.search(directionsFor(session.hull), APART);
            return descent.best;
        }

        // The hull's axes, and directions spread evenly over the upper half of the sphere, along a spiral.
        private static function directionsFor(hull:ConvexHull):Vector.<Number>
        {
            var directions:Vector.<Number> = hull.axes.concat();
            for (var i:int = 0; i < DIRECTIONS; i++)
            {
                var z:Number = 1 - (i + 0.5) / DIRECTIONS;
                var angle:Number = i * 180 * (3 - Math.sqrt(5));
                var across:Number = Math.sqrt(1 - z * z);
                directions.push(across * Trigonometry.cosine(angle), across * Trigonometry.sine(angle), z);
            }
            return directions;
        }
    }
}
