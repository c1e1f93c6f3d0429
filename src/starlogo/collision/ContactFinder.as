package starlogo.collision
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.motion.Touch;
    import starlogo.motion.TouchFinder;
    import starlogo.motion.Way;

    /** Finds how shapes touch that a search has found. */
    internal final class ContactFinder
    {
        private var _strategy:ShapeStrategy;
        private var _shapes:ShapeCache;
        private var _swept:SweptSearch;
        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);
        private var _finder:TouchFinder = new TouchFinder();
        private var _touch:Touch = new Touch();

        /**
         * @param strategy says what shapes agents have
         * @param shapes has them
         * @param swept has the ways of those that sweep
         */
        public function ContactFinder(strategy:ShapeStrategy, shapes:ShapeCache, swept:SweptSearch)
        {
            _strategy = strategy;
            _shapes = shapes;
            _swept = swept;
        }

        /**
         * An agent's shape as the last search has left it; as it is now, if none has seen it.
         *
         * @throws ArgumentError if its model is unknown, or still loading
         */
        public function shapeOf(agent:Agent):WorldShape
        {
            var shape:WorldShape = _shapes.find(agent);
            if (shape.level == null)
            {
                shape = _shapes.shapeOf(agent);
            }
            if (shape.level == null)
            {
                throw new ArgumentError(agent + ": its model is still loading");
            }
            return shape;
        }

        /**
         * Finds how two shapes touch.
         *
         * @param a a shape as the last search saw it
         * @param b another
         * @param isSwept whether the last search was one of these
         * @param out takes it
         */
        public function find(a:WorldShape, b:WorldShape, isSwept:Boolean, out:Contact):void
        {
            var way:Way = _swept.way;
            var isPassing:Boolean = isSwept && _swept.isPairSwept(a, b);
            var time:Number = isPassing ? _swept.firstOverlap(a, b) : 1;
            if (time == Way.NEVER)
            {
                isPassing = false;
                time = 1;
            }
            if (!isPassing)
            {
                way.endAfter(0, 0, 0);
            }
            var touch:Touch = _touch;
            if (a.isSphere && b.isSphere)
            {
                takeSphere(a, _sphereA);
                takeSphere(b, _sphereB);
                _finder.find(_sphereA, _sphereB, way.startX + time * way.x, way.startY + time * way.y, way.startZ + time * way.z, touch);
            }
            else
            {
                _strategy.findTouch(a, b, way, time, touch);
            }
            out.time = time;
            out.depth = touch.depth;
            out.normal.setTo(touch.normalX, touch.normalY, touch.normalZ);
            out.point.setTo(touch.x, touch.y, touch.z);
            if (isPassing)
            {
                // from where b is now to where it was
                var motion:MovingProxy = b.motion;
                out.point.x -= (1 - time) * motion.wayX;
                out.point.y -= (1 - time) * motion.wayY;
                out.point.z -= (1 - time) * motion.wayZ;
            }
        }

        private static function takeSphere(shape:WorldShape, sphere:Sphere):void
        {
            var center:Vector3D = sphere.center;
            center.x = shape.x;
            center.y = shape.y;
            center.z = shape.z;
            sphere.radius = shape.halfX;
        }
    }
}
