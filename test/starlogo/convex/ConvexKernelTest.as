package starlogo.convex
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Box;
    import starlogo.engine;
    import support.Complaints;
    import support.Effort;
    import support.RandomConvex;

    use namespace engine;

    /**
     * The four questions about convex shapes of all kinds and families. Distances prove themselves: both points are in their shapes, and a plane
     * between them keeps the shapes apart.
     */
    public class ConvexKernelTest
    {
        // of the sizes and the distance
        private static const PRECISION:Number = 2e-14;

        private var _random:SeededRandom = new SeededRandom(7101);
        private var _draw:RandomConvex = new RandomConvex(_random);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _pair:ConvexKernel = new ConvexKernel();
        private var _points:ClosestPoints = new ClosestPoints();
        private var _contact:ContactPoint = new ContactPoint();
        private var _wrong:Complaints = new Complaints();

        private var _a:ConvexShape;
        private var _b:ConvexShape;

        // The sum of the sizes, and the text of the pair.
        private var _size:Number;
        private var _what:String;

        [Test]
        public function distancesProveThemselves():void
        {
            var apart:int = 0;
            var overlapping:int = 0;
            forAll(Effort.choose(40, 2000), function():void
                {
                    _pair.findClosest(_a, _b, _points);
                    provePoints();
                    apart += _points.distance > 0 ? 1 : 0;
                    overlapping += _points.distance > 0 ? 0 : 1;
                });
            _wrong.assertNone();
            assertTrue(apart + " apart, " + overlapping + " overlap", apart > overlapping / 4 && overlapping > apart / 4);
        }

        [Test]
        public function tinyGapsProveThemselves():void
        {
            var small:int = 0;
            forAll(Effort.choose(40, 2000), function():void
                {
                    if (!approach(_random.logBetween(1e-15, 1e-6)))
                    {
                        return;
                    }
                    _pair.findClosest(_a, _b, _points);
                    provePoints();
                    small += _points.distance > 0 && _points.distance < 1e-6 * _size ? 1 : 0;
                });
            _wrong.assertNone();
            assertTrue(small + " with a small gap", small > 300);
        }

        [Test]
        public function shapesTouchUpToTheSameGapStandingAndMoving():void
        {
            var touching:int = 0;
            var count:int = 0;
            var motion:RelativeMotion = new RelativeMotion(0);
            forAll(Effort.choose(40, 2000), function():void
                {
                    if (_random.chance(0.3))
                    {
                        _a.margin += _random.logBetween(1e-14, 1e-12) * _size;
                    }
                    approach(_random.logBetween(1e-17, 1e-11));
                    motion.startX = motion.startY = motion.startZ = motion.x = motion.y = motion.z = 0;
                    _pair.findTimeOfImpact(_a, _b, motion);
                    var areTouching:Boolean = _pair.areTouching(_a, _b);
                    _wrong.addIf(areTouching != (motion.time == 0), "standing and moving", _what + ": " + motion.time);
                    _pair.findClosest(_a, _b, _points);
                    var reach:Number = 4e-14 * (_a.radius + _b.radius) + _a.margin + _b.margin + 1e-15 * (_a.boundingRadius + _b.boundingRadius);
                    _wrong.addIf(!areTouching && _points.distance < reach - 1e-15 * _size, "apart", _what + ": " + _points.distance);
                    _wrong.addIf(areTouching && _points.distance > reach + 1e-15 * _size, "touching", _what + ": " + _points.distance);
                    touching += areTouching ? 1 : 0;
                    count++;
                });
            _wrong.assertNone();
            assertTrue(touching + " touch of " + count, touching > count / 5 && touching < count * 0.9);
        }

        /** A tetrahedron a billion times as long as it is thick. Normals of its faces have lost all digits. */
        [Test]
        public function aPointBesideANarrowTetrahedronIsOutside():void
        {
            _a = hullOf(7.1095889, -45.036795811668, 67.19012, new <Number>[16.8627359, 19.7274116, -6.373938]);
            _b = hullOf(0, 0, 0, new <Number>[8939.9933, -9438.621247910183, 22680.166, 16504.193588316, -17424.71465, 41870.03656227,
                        6500.596626, -6863.1672746, 16491.5794, -9687.1621265, 10227.4633945, -24575.6832]);
            _pair.findClosest(_a, _b, _points);
            // by exact arithmetic
            assertTrue("distance " + _points.distance, Math.abs(_points.distance - 4.538187055952256e-7) < 1e-15 * (_a.boundingRadius + _b.boundingRadius));
            assertTrue("touch", !_pair.areTouching(_a, _b));
        }

        /** The gap along a direction is a little more than the one that counts as touching. The distance between the points is a little less. */
        [Test]
        public function aGapAtTheBorderIsTheSameStandingAndMoving():void
        {
            _a = hullOf(0.5169904292095318, 0.09941668893009348, -0.20705184533488613, new <Number>[0, 0, 0, -0.713499002691224, 0.1994895781607433, 0.7774738874897469]);
            _b = hullOf(0.18985801810264105, 0.19088073645961934, 0.14941243342071234, new <Number>[0, 0, 0, -0.47, -0.47, -0.4]);
            _a.margin = _b.margin = 0;
            var motion:RelativeMotion = new RelativeMotion(0);
            _pair.findTimeOfImpact(_a, _b, motion);
            assertTrue("time " + motion.time, _pair.areTouching(_a, _b) == (motion.time == 0));
        }

        [Test]
        public function theOtherOrderGivesTheSameBits():void
        {
            var other:ClosestPoints = new ClosestPoints();
            var swapped:ContactPoint = new ContactPoint();
            var motion:RelativeMotion = new RelativeMotion(0);
            var back:RelativeMotion = new RelativeMotion(0);
            var hits:int = 0;
            forAll(Effort.choose(40, 1000), function():void
                {
                    approach((_random.chance() ? 1 : -1) * _random.logBetween(1e-16, 1e-2));
                    _wrong.addIf(_pair.areTouching(_a, _b) != _pair.areTouching(_b, _a), "verdict", _what);
                    _pair.findClosest(_a, _b, _points);
                    _pair.findClosest(_b, _a, other);
                    _wrong.addIf(_points.distance != other.distance || _points.a.x != other.b.x || _points.a.y != other.b.y || _points.a.z != other.b.z
                            || _points.b.x != other.a.x || _points.b.y != other.a.y || _points.b.z != other.a.z, "points", _what);
                    setMotion(motion, _random.between(0, 3), _random.between(-1, 2));
                    back.startX = -motion.startX;
                    back.startY = -motion.startY;
                    back.startZ = -motion.startZ;
                    back.x = -motion.x;
                    back.y = -motion.y;
                    back.z = -motion.z;
                    _pair.findTimeOfImpact(_a, _b, motion);
                    _pair.findTimeOfImpact(_b, _a, back);
                    _wrong.addIf(motion.time != back.time, "time", _what + ": " + motion.time + " and " + back.time);
                    hits += motion.time <= 1 ? 1 : 0;
                    motion.time = back.time = Math.min(1, motion.time);
                    _pair.findContact(_a, _b, motion, _contact);
                    _pair.findContact(_b, _a, back, swapped);
                    var isSame:Boolean = _contact.depth == swapped.depth && _contact.normalX == -swapped.normalX && _contact.normalY == -swapped.normalY
                        && _contact.normalZ == -swapped.normalZ;
                    _wrong.addIf(!isSame && !isConcentric(), "contact", _what + ": " + _contact.depth + " and " + swapped.depth);
                });
            _wrong.assertNone();
            assertTrue(hits + " hits", hits > 200);
        }

        [Test]
        public function timesAreThoseOfTheFirstTouch():void
        {
            var motion:RelativeMotion = new RelativeMotion(0);
            var hits:int = 0;
            var misses:int = 0;
            forAll(Effort.choose(40, 1000), function():void
                {
                    setMotion(motion, _random.between(0, 3), _random.between(-1, 2));
                    if (!(gapAt(motion, 0) > 1e-9 * _size))
                    {
                        return;
                    }
                    _pair.findTimeOfImpact(_a, _b, motion);
                    var time:Number = motion.time;
                    var what:String = _what + ", time " + time;
                    if (time <= 1)
                    {
                        hits++;
                        _wrong.addIf(!(time > 0), "too early", what);
                        _wrong.addIf(!(gapAt(motion, time) <= 1e-9 * _size), "not yet", what + ": " + gapAt(motion, time));
                        _wrong.addIf(gapAt(motion, time * (1 - 1e-7)) <= 0 && signedGapAt(motion, time * (1 - 1e-7)) < -1e-12 * _size, "through", what);
                    }
                    else
                    {
                        misses++;
                        _wrong.addIf(time != RelativeMotion.NEVER, "never", what);
                        _wrong.addIf(leastGap(motion) < -1e-12 * _size, "missed", what);
                    }
                    motion.latestTime = time / 2 < 1 ? time / 2 : 1;
                    _pair.findTimeOfImpact(_a, _b, motion);
                    _wrong.addIf(motion.time != RelativeMotion.NEVER, "latest", what + ": " + motion.time);
                    motion.latestTime = 1;
                });
            _wrong.assertNone();
            assertTrue(hits + " hits, " + misses + " misses", hits > 200 && misses > 200);
        }

        /**
         * The corners of the world are 3e9 apart. Squares of such distances have no digits left for a shape of size 1. Shapes must meet that overlap
         * by more than their places are rounded.
         */
        [Test]
        public function shapesThatComeFromFarAwayAreMet():void
        {
            var motion:RelativeMotion = new RelativeMotion();
            var count:int = 0;
            for each (var distance:Number in [1e3, 1e7, 4e8, 9e8, 3e9])
            {
                forAll(Effort.choose(2, 20), function():void
                    {
                        var direction:Vector3D = _structures.direction();
                        _a = RandomConvex.moved(_a, _b.origin.x - _a.origin.x, _b.origin.y - _a.origin.y, _b.origin.z - _a.origin.z);
                        _pair.findContact(_a, _b, new RelativeMotion(0), _contact);
                        if (!(_contact.depth > 1e-15 * (distance + Math.abs(_b.origin.x))))
                        {
                            return;
                        }
                        count++;
                        var a:ConvexShape = RandomConvex.moved(_a, -distance * direction.x, -distance * direction.y, -distance * direction.z);
                        motion.x = 2 * distance * direction.x;
                        motion.y = 2 * distance * direction.y;
                        motion.z = 2 * distance * direction.z;
                        _pair.findTimeOfImpact(a, _b, motion);
                        _wrong.addIf(!(motion.time <= 0.5 + 1e-14), "missed from " + distance, _what + ", time " + motion.time);
                    });
            }
            _wrong.assertNone();
            assertTrue(count + " pairs", count > Effort.choose(75, 750));
        }

        /** Shapes with faces and edges along the axes, which come near each other at any angle: rounding hides the direction of a short gap. */
        [Test]
        public function shortWaysOfLevelShapesAreExact():void
        {
            var motion:RelativeMotion = new RelativeMotion(0);
            var hits:int = 0;
            var count:int = 0;
            forAll(Effort.choose(60, 2000), function():void
                {
                    var isBelow:Boolean = approach(_random.logBetween(1e-12, 1e-6));
                    var aside:Vector3D = _structures.direction();
                    aside.scaleBy(_random.logBetween(1e-12, 1e-6) * _size);
                    _a = RandomConvex.moved(_a, aside.x, aside.y, aside.z);
                    motion.startX = motion.startY = motion.startZ = 0;
                    if (!isBelow || !(gapAt(motion, 0) > 1e-13 * _size))
                    {
                        return;
                    }
                    var way:Vector3D = _structures.direction();
                    motion.x = _size * _random.pick([0, way.x]);
                    motion.y = _size * _random.pick([0, way.y]);
                    motion.z = _size * way.z;
                    _pair.findTimeOfImpact(_a, _b, motion);
                    var time:Number = motion.time;
                    count++;
                    if (time <= 1)
                    {
                        hits++;
                        _wrong.addIf(!(gapAt(motion, time) <= 1e-13 * _size), "not yet", _what + ", time " + time + ": " + gapAt(motion, time));
                        // The depth alone proves nothing: it may be off by 1e-9 of the sizes (Tolerances.SEPARATION). A motion that has gone so deep
                        // has touched before.
                        var before:Number = time - 1e-11 * _size / new Vector3D(motion.x, motion.y, motion.z).length;
                        _wrong.addIf(signedGapAt(motion, time) < -1e-11 * _size && gapAt(motion, before) == 0, "through", _what + ", time " + time + ": "
                                + signedGapAt(motion, time));
                    }
                    else
                    {
                        _wrong.addIf(leastGap(motion) < -1e-12 * _size, "missed", _what);
                    }
                });
            _wrong.assertNone();
            assertTrue(hits + " hits of " + count, hits > count / 4 && hits < count * 0.9);
        }

        /** Moved by the depth and a little more they are apart, by a little less they are not. */
        [Test]
        public function contactsSeparate():void
        {
            var still:RelativeMotion = new RelativeMotion(0);
            var deep:int = 0;
            forAll(Effort.choose(40, 1000), function():void
                {
                    if (_random.chance(0.4))
                    {
                        approach(-_random.logBetween(1e-12, 1e-2));
                    }
                    _pair.findClosest(_a, _b, _points);
                    if (_points.distance > 0)
                    {
                        return;
                    }
                    _pair.findContact(_a, _b, still, _contact);
                    var normal:Vector3D = new Vector3D(_contact.normalX, _contact.normalY, _contact.normalZ);
                    _wrong.addIf(Math.abs(normal.length - 1) > 1e-12, "unit", _what);
                    // far away, places are rounded
                    var extent:Number = Math.max(_a.boundingRadius / 2 + _a.radius, _b.boundingRadius / 2 + _b.radius) + 1e-6 * Math.abs(_b.origin.x);
                    if (extent == 0)
                    {
                        return;
                    }
                    _wrong.addIf(distanceAfter(normal, _contact.depth + 1e-9 * extent) <= 0, "still touch", _what + ": " + _contact.depth);
                    if (_contact.depth > 1e-9 * extent)
                    {
                        deep++;
                        // The distance of shapes that overlap by little may be as much as rounding instead of 0.
                        var rounding:Number = 1e-15 * (sizeOf(_a) + sizeOf(_b));
                        _wrong.addIf(distanceAfter(normal, _contact.depth - 1e-9 * extent) > rounding, "too deep", _what + ": " + _contact.depth);
                    }
                    var point:Vector3D = new Vector3D(_contact.x, _contact.y, _contact.z);
                    var off:Number = Math.max(_draw.outside(_a, point), _draw.outside(_b, point));
                    // If two directions separate needles equally well but for rounding, one is perpendicular to an edge that touches, and the other
                    // one touches at a corner of that edge. The corner is this far off (4.4e-8, by exact arithmetic).
                    _wrong.addIf(off > _contact.depth + 1e-7 * extent, "point", _what + ": " + off + " of depth " + _contact.depth);
                });
            _wrong.assertNone();
            assertTrue(deep + " deep", deep > 150);
        }

        /** Boxes along the axes, with corners at integers: everything about them is known. Each is a box, or a hull of its corners. */
        [Test]
        public function boxesOfIntegersAreExact():void
        {
            var still:RelativeMotion = new RelativeMotion(0);
            var touching:int = 0;
            var corners:int = 0;
            for (var i:int = Effort.choose(2000, 100000); i > 0; i--)
            {
                var middle:Array = [_random.integer(-6, 6), _random.integer(-6, 6), _random.integer(-6, 6)];
                var halvesA:Array = [_random.integer(0, 3), _random.integer(0, 3), _random.integer(0, 3)];
                var halvesB:Array = [_random.integer(0, 3), _random.integer(0, 3), _random.integer(0, 3)];
                _a = integerBox(middle, halvesA, _random.chance());
                _b = integerBox([0, 0, 0], halvesB, _random.chance());
                var squared:Number = 0;
                var depth:Number = Infinity;
                var level:int = 0;
                for (var k:int = 0; k < 3; k++)
                {
                    var overlap:Number = halvesA[k] + halvesB[k] - Math.abs(middle[k]);
                    squared += overlap < 0 ? overlap * overlap : 0;
                    depth = Math.min(depth, overlap);
                    level += overlap == 0 ? 1 : 0;
                }
                _what = "boxes " + [middle, halvesA, halvesB].join("; ");
                _wrong.addIf(_pair.areTouching(_a, _b) != (squared == 0), "verdict", _what);
                _pair.findClosest(_a, _b, _points);
                _wrong.addIf(Math.abs(_points.distance - Math.sqrt(squared)) > 1e-14, "distance", _what + ": " + _points.distance);
                if (squared == 0)
                {
                    touching++;
                    corners += level > 1 ? 1 : 0;
                    _pair.findContact(_a, _b, still, _contact);
                    _wrong.addIf(Math.abs(_contact.depth - depth) > 1e-14, "depth", _what + ": " + _contact.depth + " for " + depth);
                }
            }
            _wrong.assertNone();
            assertTrue(touching + " touch, " + corners + " at corners or edges", touching > 200 && corners > 20);
        }

        private static function integerBox(middle:Array, halves:Array, isHull:Boolean):ConvexShape
        {
            var shape:ConvexShape = new ConvexShape();
            var center:Vector3D = new Vector3D(middle[0], middle[1], middle[2]);
            new Box(center, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, halves[0], halves[1], halves[2]).setShape(shape);
            if (isHull)
            {
                var box:ConvexShape = shape;
                shape = new ConvexShape();
                shape.setHull(center, box.points.concat(), box.faces, box.edges);
            }
            return shape;
        }

        // A hull of points without faces and edges.
        private static function hullOf(x:Number, y:Number, z:Number, points:Vector.<Number>):ConvexShape
        {
            var shape:ConvexShape = new ConvexShape();
            shape.setHull(new Vector3D(x, y, z), points, new Vector.<int>(), new Vector.<int>());
            return shape;
        }

        // Calls a function for pairs of all kinds and families.
        private function forAll(count:int, check:Function):void
        {
            for (var kindA:int = 0; kindA < RandomConvex.KINDS; kindA++)
            {
                for (var kindB:int = kindA; kindB < RandomConvex.KINDS; kindB++)
                {
                    for (var i:int = 0; i < count; i++)
                    {
                        var family:int = i % RandomConvex.FAMILIES;
                        var isLattice:Boolean = family == RandomConvex.LATTICE;
                        var far:Number = _random.chance(0.2) ? 1e4 : 0;
                        var origin:Vector3D = new Vector3D(far, -far, far);
                        _b = _draw.shape(kindB, family, origin);
                        _a = _draw.shape(kindA, family, origin);
                        var reach:Number = sizeOf(_a) + sizeOf(_b);
                        var way:Vector3D = _structures.direction();
                        way.scaleBy(_random.between(0, 1) * reach);
                        if (isLattice)
                        {
                            way.setTo(_random.integer(-4, 4), _random.integer(-4, 4), _random.integer(-4, 4));
                        }
                        _a = RandomConvex.moved(_a, way.x, way.y, way.z);
                        _size = reach + way.length + 0.1 * far;
                        _what = "kinds " + kindA + " and " + kindB + ", family " + family + ", number " + i;
                        check();
                    }
                }
            }
        }

        private static function sizeOf(shape:ConvexShape):Number
        {
            return shape.boundingRadius + shape.radius;
        }

        // Moves a along the line between the closest points until the gap is a fraction of the sizes, if the two are apart.
        private function approach(gap:Number):Boolean
        {
            _pair.findClosest(_a, _b, _points);
            var way:Vector3D = _points.a.subtract(_points.b);
            if (!(_points.distance > 0) || !(way.normalize() > 0))
            {
                return false;
            }
            var by:Number = gap * (sizeOf(_a) + sizeOf(_b)) - _points.distance;
            _a = RandomConvex.moved(_a, by * way.x, by * way.y, by * way.z);
            return true;
        }

        private function provePoints():void
        {
            var pointA:Vector3D = _points.a.clone();
            var pointB:Vector3D = _points.b.clone();
            var way:Vector3D = pointA.subtract(pointB);
            var slack:Number = PRECISION * _size;
            var text:String = _what + ": distance " + _points.distance;
            _wrong.addIf(_draw.outside(_a, pointA) > slack, "first point", text + ", off by " + _draw.outside(_a, pointA));
            _wrong.addIf(_draw.outside(_b, pointB) > slack, "second point", text + ", off by " + _draw.outside(_b, pointB));
            _wrong.addIf(Math.abs(way.length - _points.distance) > slack, "as far apart as the points", text);
            if (_points.distance > slack)
            {
                way.normalize();
                var back:Vector3D = way.clone();
                back.negate();
                var between:Number = -(RandomConvex.support(_a, back) + RandomConvex.support(_b, way));
                // rounding turns a short line between two points
                var unsure:Number = slack + 2 * PRECISION * _size * _size / _points.distance;
                _wrong.addIf(_points.distance - between > unsure, "nothing is nearer", text + ", plane " + between);
            }
        }

        // A motion that comes from a multiple of the sizes away to a place beside b, and as far again.
        private function setMotion(motion:RelativeMotion, from:Number, aside:Number):void
        {
            var way:Vector3D = _structures.direction();
            var beside:Vector3D = _structures.direction();
            beside.scaleBy(aside * _size / 2);
            way.scaleBy((0.5 + from) * _size);
            motion.startX = _b.origin.x - _a.origin.x - way.x;
            motion.startY = _b.origin.y - _a.origin.y - way.y;
            motion.startZ = _b.origin.z - _a.origin.z - way.z;
            motion.x = 2 * way.x + beside.x;
            motion.y = 2 * way.y + beside.y;
            motion.z = 2 * way.z + beside.z;
        }

        private function there(motion:RelativeMotion, time:Number):ConvexShape
        {
            return RandomConvex.moved(_a, motion.startX + time * motion.x, motion.startY + time * motion.y, motion.startZ + time * motion.z);
        }

        private function gapAt(motion:RelativeMotion, time:Number):Number
        {
            _pair.findClosest(there(motion, time), _b, _points);
            return _points.distance;
        }

        // Less than 0 if the two overlap.
        private function signedGapAt(motion:RelativeMotion, time:Number):Number
        {
            var gap:Number = gapAt(motion, time);
            if (gap > 0)
            {
                return gap;
            }
            _pair.findContact(there(motion, time), _b, new RelativeMotion(0), _contact);
            return -_contact.depth;
        }

        // The distance is a convex function of time.
        private function leastGap(motion:RelativeMotion):Number
        {
            var low:Number = 0;
            var high:Number = 1;
            for (var i:int = 0; i < 100; i++)
            {
                var third:Number = (high - low) / 3;
                if (signedGapAt(motion, low + third) < signedGapAt(motion, high - third))
                {
                    high -= third;
                }
                else
                {
                    low += third;
                }
            }
            return signedGapAt(motion, (low + high) / 2);
        }

        private function distanceAfter(normal:Vector3D, by:Number):Number
        {
            _pair.findClosest(RandomConvex.moved(_a, by * normal.x, by * normal.y, by * normal.z), _b, _points);
            return _points.distance;
        }

        private function isConcentric():Boolean
        {
            return _a.origin.x == _b.origin.x && _a.origin.y == _b.origin.y && _a.origin.z == _b.origin.z;
        }
    }
}
