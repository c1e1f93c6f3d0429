package starlogo.fitting.minimal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.fitting.EnclosingStructures;
    import starlogo.fitting.Fit;
    import starlogo.fitting.FitSession;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.geometry.Trigonometry;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Searches all directions for the smallest capsule, in steps. It measures many directions, and descends from the best of them. It is a
     * part of MinimalCapsuleFitter.
     *
     * @private
     */
    public final class CapsuleSearch extends StepSequence
    {
        private static const DIRECTIONS:int = 60;

        // The most descents, and the smallest angle between the directions of two of them, in radians.
        private static const MAX_DESCENTS:int = 6;
        private static const MIN_ANGLE:Number = 0.15;

        // The radii to try, as multiples of the circle's radius.
        private static const RADII:Vector.<Number> = new <Number>[1, 1.02, 1.05, 1.1, 1.2, 1.35];

        /** The smallest capsule so far. */
        public var best:Capsule;

        private var _session:FitSession;

        /**
         * @param session the vertices; their hull may not exist before the first step
         * @param sphereFit finds the smallest sphere around them
         */
        public function CapsuleSearch(session:FitSession, sphereFit:Fit)
        {
            _session = session;
            add(sphereFit).call(function():void
                {
                    start(Sphere(sphereFit.structure));
                });
        }

        private function start(sphere:Sphere):void
        {
            var directions:Vector.<Vector3D> = directionsFor(_session.hull);
            var volumes:Array = [];
            best = new Capsule(sphere.center, sphere.center, sphere.radius);
            if (best.volume == 0)
            {
                // nothing is smaller than a point
                return;
            }
            slices(directions.length, 1, function(index:int, end:int):void
                {
                    volumes.push(capsuleAlong(directions[index]).volume);
                }).begin(function():Steps
                {
                    var starts:Vector.<Vector3D> = chooseStarts(directions, volumes);
                    return new StepSequence().beginEach(starts.length, function(index:int):Steps
                        {
                            return descending(starts[index]);
                        });
                });
        }

        // The directions from which to descend. They give the smallest volumes, and are apart from one another.
        private static function chooseStarts(directions:Vector.<Vector3D>, volumes:Array):Vector.<Vector3D>
        {
            var starts:Vector.<Vector3D> = new Vector.<Vector3D>();
            for (var i:int = 0; i < volumes.length && starts.length < MAX_DESCENTS; i++)
            {
                // The least volume left. Of equal ones it is the first, which a sort does not promise.
                var least:int = 0;
                for (var k:int = 1; k < volumes.length; k++)
                {
                    least = volumes[k] < volumes[least] ? k : least;
                }
                volumes[least] = Infinity;
                if (!isNear(starts, directions[least]))
                {
                    starts.push(directions[least]);
                }
            }
            return starts;
        }

        // The descent from the best capsule along a direction.
        private function descending(direction:Vector3D):Steps
        {
            var descent:CapsuleDescent = new CapsuleDescent(_session.hull.points, capsuleAlong(direction));
            return new StepSequence().add(descent).call(function():void
                {
                    keepIfSmaller(descent.capsule);
                });
        }

        // Keeps the smallest capsule along the axis of another one, if it is smaller than the best.
        private function keepIfSmaller(found:Capsule):void
        {
            var axis:Vector3D = found.end.subtract(found.start);
            if (axis.normalize() == 0)
            {
                axis.setTo(1, 0, 0);
            }
            var radius:Number = Math.max(found.radius, EnclosingStructures.distanceFromLine(_session.vertices, found.start, axis));
            var capsule:Capsule = EnclosingStructures.capsule(_session.vertices, found.start, axis, Infinity, -Infinity, radius);
            if (capsule.volume < best.volume)
            {
                best = capsule;
            }
        }

        // Whether the angle to one of the others is small. Opposite directions count as one.
        private static function isNear(others:Vector.<Vector3D>, direction:Vector3D):Boolean
        {
            for each (var other:Vector3D in others)
            {
                if (direction.crossProduct(other).lengthSquared < MIN_ANGLE * MIN_ANGLE)
                {
                    return true;
                }
            }
            return false;
        }

        // Finds the best capsule along a unit vector, trying several radii. Its axis goes through the smallest circle around the points as
        // seen along the vector.
        private function capsuleAlong(axis:Vector3D):Capsule
        {
            var points:Vector.<Number> = _session.hull.points;
            var seen:Vector.<Number> = new Vector.<Number>(points.length);
            for (var i:int = 0; i < points.length; i += 3)
            {
                var along:Number = points[i] * axis.x + points[i + 1] * axis.y + points[i + 2] * axis.z;
                seen[i] = points[i] - along * axis.x;
                seen[i + 1] = points[i + 1] - along * axis.y;
                seen[i + 2] = points[i + 2] - along * axis.z;
            }
            var circle:SmallestEnclosingBall = new SmallestEnclosingBall(seen);
            var smallest:Capsule = null;
            for each (var multiple:Number in RADII)
            {
                var capsule:Capsule = EnclosingStructures.capsule(points, circle.center, axis, Infinity, -Infinity, multiple * circle.radius);
                if (smallest == null || capsule.volume < smallest.volume)
                {
                    smallest = capsule;
                }
            }
            return smallest;
        }

        // The hull's axes, and directions spread evenly over the upper half of the sphere, along a spiral.
        private static function directionsFor(hull:ConvexHull):Vector.<Vector3D>
        {
            var directions:Vector.<Vector3D> = new Vector.<Vector3D>();
            for (var axis:int = 0; axis < hull.axes.length; axis += 3)
            {
                directions.push(new Vector3D(hull.axes[axis], hull.axes[axis + 1], hull.axes[axis + 2]));
            }
            for (var i:int = 0; i < DIRECTIONS; i++)
            {
                var z:Number = 1 - (i + 0.5) / DIRECTIONS;
                var angle:Number = i * 180 * (3 - Math.sqrt(5));
                var across:Number = Math.sqrt(1 - z * z);
                directions.push(new Vector3D(across * Trigonometry.cosine(angle), across * Trigonometry.sine(angle), z));
            }
            return directions;
        }
    }
}
