package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * The gap between two structures, by a way that has nothing in common with the engine's: every structure is a sum of
     * segments [-1, 1] * g around a middle (none, one or three of them), widened by a radius, and so is the difference of
     * two. The point of it nearest to the origin is found one coefficient at a time, over and over; a plane through it
     * bounds the gap from below, so that the answer carries its own proof.
     */
    public final class ConvexReference
    {
        private static const MAX_SWEEPS:int = 3000;

        /** Set by compare: the gap is not less than this... */
        public var lowerBound:Number;

        /** ...and not more than this. Below 0, the structures meet. */
        public var upperBound:Number;

        private var _middle:Vector3D;
        private var _generators:Vector.<Vector3D> = new Vector.<Vector3D>();
        private var _radius:Number;

        /** Bounds the gap between two structures to within a precision, unless that takes too long. */
        public function compare(a:BoundingStructure, b:BoundingStructure, precision:Number):void
        {
            _generators.length = 0;
            _radius = 0;
            _middle = new Vector3D();
            add(a, 1);
            add(b, -1);
            minimize(precision);
        }

        private function add(structure:BoundingStructure, sign:int):void
        {
            var middle:Vector3D;
            if (structure is Sphere)
            {
                middle = Sphere(structure).center.clone();
                _radius += Sphere(structure).radius;
            }
            else if (structure is Capsule)
            {
                var capsule:Capsule = Capsule(structure);
                middle = capsule.start.add(capsule.end);
                middle.scaleBy(0.5);
                addGenerator(capsule.end.subtract(middle), 1);
                _radius += capsule.radius;
            }
            else
            {
                var box:Box = Box(structure);
                middle = box.center.clone();
                addGenerator(box.axisX, box.halfX);
                addGenerator(box.axisY, box.halfY);
                addGenerator(box.axisZ, box.halfZ);
            }
            middle.scaleBy(sign);
            _middle.incrementBy(middle);
        }

        private function addGenerator(direction:Vector3D, half:Number):void
        {
            var generator:Vector3D = direction.clone();
            generator.scaleBy(half);
            if (generator.lengthSquared > 0)
            {
                _generators.push(generator);
            }
        }

        private function minimize(precision:Number):void
        {
            var coefficients:Vector.<Number> = new Vector.<Number>(_generators.length, true);
            var x:Number = _middle.x;
            var y:Number = _middle.y;
            var z:Number = _middle.z;
            for (var sweep:int = 0; sweep < MAX_SWEEPS; sweep++)
            {
                for (var i:int = 0; i < _generators.length; i++)
                {
                    var g:Vector3D = _generators[i];
                    var best:Number = coefficients[i] - (x * g.x + y * g.y + z * g.z) / g.lengthSquared;
                    best = best < -1 ? -1 : (best > 1 ? 1 : best);
                    var step:Number = best - coefficients[i];
                    coefficients[i] = best;
                    x += step * g.x;
                    y += step * g.y;
                    z += step * g.z;
                }
                if (sweep % 8 == 7)
                {
                    setBounds(x, y, z);
                    if (upperBound - lowerBound <= precision || upperBound < 0)
                    {
                        return;
                    }
                }
            }
        }

        private function setBounds(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            upperBound = length - _radius;
            lowerBound = -_radius;
            if (length == 0)
            {
                return;
            }
            var nearest:Number = x * _middle.x + y * _middle.y + z * _middle.z;
            for (var i:int = 0; i < _generators.length; i++)
            {
                var g:Vector3D = _generators[i];
                nearest -= Math.abs(x * g.x + y * g.y + z * g.z);
            }
            lowerBound = Math.max(lowerBound, nearest / length - _radius);
        }
    }
}
