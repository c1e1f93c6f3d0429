package starlogo.fitting
{
    import evaluation.literal.LiteralOrientedBoxFit;
    import flash.geom.Vector3D;
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import support.Effort;
    import support.FitChecks;
    import support.PointSets;
    import evaluation.pairs.SeededRandom;
    import support.SmallestSphereReference;

    public class FitterTest
    {
        private static function thesisFitters():Vector.<Fitter>
        {
            var oriented:Fitter = new OrientedBoxFitter(15);
            return new <Fitter>[new NaiveSphereFitter(), new RitterSphereFitter(),
                    new RitterSphereFitter(RitterSphereFitter.FARTHEST_FROM_FIRST), new CentredRitterSphereFitter(),
                    new AxisAlignedBoxFitter(), new ZAlignedBoxFitter(10), oriented, new CapsuleFitter(oriented),
                    new CapsuleFitter(new AxisAlignedBoxFitter()), new CylinderFitter(oriented)];
        }

        private static function minimalFitters():Vector.<Fitter>
        {
            return new <Fitter>[new MinimalSphereFitter(), new MinimalBoxFitter(), new MinimalCapsuleFitter()];
        }

        private static function allFitters():Vector.<Fitter>
        {
            return thesisFitters().concat(minimalFitters());
        }

        [Test]
        public function enclosesEveryVertexOfHardSets():void
        {
            for (var seed:int = 1; seed <= 5; seed++)
            {
                encloseHardSets(seed, thesisFitters(), 1);
            }
        }

        [Test]
        public function minimalFitsEncloseEveryVertexOfHardSets():void
        {
            encloseHardSets(1, minimalFitters(), Effort.choose(3, 1));
        }

        [Test]
        public function minimalFitsAreTheSmallest():void
        {
            var sets:Array = PointSets.hard(new SeededRandom(2));
            for (var i:int = 0; i < sets.length; i += 4)
            {
                var session:FitSession = new FitSession(sets[i + 1]);
                var rounding:Number = 1e-9 * Math.pow(session.hull.extent, 3);
                var sphere:Number = session.fit(new MinimalSphereFitter()).volume;
                var box:Number = session.fit(new MinimalBoxFitter()).volume;
                for each (var fitter:Fitter in thesisFitters())
                {
                    var found:BoundingStructure = session.fit(fitter);
                    var least:Number = found is Sphere ? sphere : (found is Box ? box : 0);
                    assertTrue(sets[i] + ", " + fitter + ": " + found.volume + " below " + least,
                            found.volume >= least * (1 - 1e-5) - rounding);
                }
                assertTrue(box >= session.hull.volume * (1 - 1e-6) - rounding);
            }
        }

        // every set, or every so many
        private static function encloseHardSets(seed:int, fitters:Vector.<Fitter>, every:int):void
        {
            var sets:Array = PointSets.hard(new SeededRandom(seed));
            for (var i:int = 0; i < sets.length; i += 2 * every)
            {
                var session:FitSession = new FitSession(sets[i + 1]);
                for each (var fitter:Fitter in fitters)
                {
                    assertEncloses(sets[i] + ", seed " + seed, fitter, session);
                }
            }
        }

        // Flash Player's Matrix3D holds single-precision numbers: the search may choose another of two rotations that are
        // nearly as good, and no more.
        [Test]
        public function singlePrecisionFindsTheSameBox():void
        {
            var sets:Array = PointSets.hard(new SeededRandom(6));
            for (var i:int = 0; i < sets.length; i += 2)
            {
                var session:FitSession = new FitSession(sets[i + 1]);
                var box:Box = Enclosing.box(session.vertices, new SingleRotationSearch(session.hull).smallestBox(15, 15, 15));
                assertEquals(sets[i], "", FitChecks.outside(box, session.vertices));
                var expected:Number = session.fit(new OrientedBoxFitter(15)).volume;
                var far:Number = 1e-6 * Math.pow(new Vector3D(session.vertices[0], session.vertices[1], session.vertices[2]).length
                        + session.hull.extent, 3);
                assertTrue(sets[i] + ": " + box.volume + " instead of " + expected, Math.abs(box.volume - expected) <= far);
            }
        }

        // Small sets against every sphere through two, three or four of the points.
        [Test]
        public function smallestSphereLikeTryingThemAll():void
        {
            var random:SeededRandom = new SeededRandom(71);
            for (var i:int = 0; i < 60; i++)
            {
                var points:Vector.<Number> = PointSets.cloud(random, random.integer(1, 8), 1, random.pick([1, 0.2, 0]), random.pick([1, 1e-3, 0]));
                points = PointSets.turned(points, random);
                var found:Number = Sphere(new MinimalSphereFitter().fit(points)).radius;
                var expected:Number = SmallestSphereReference.radius(points);
                assertTrue(points + ": " + found + " instead of " + expected, Math.abs(found - expected) <= 1e-9);
            }
        }

        [Test]
        public function enclosesManyVertices():void
        {
            var count:int = Effort.choose(20000, 100000);
            var cloud:Vector.<Number> = PointSets.cloud(new SeededRandom(31), count);
            var session:FitSession = new FitSession(cloud);
            for each (var fitter:Fitter in allFitters())
            {
                assertHoldsAll("a cloud of " + count, fitter, session.fit(fitter), cloud);
            }
        }

        [Test]
        public function orientedBoxIsTheLiteralOne():void
        {
            var random:SeededRandom = new SeededRandom(41);
            for (var i:int = 0; i < 6; i++)
            {
                var cloud:Vector.<Number> = PointSets.turned(PointSets.cloud(random, 60, 1, 0.6, 0.3), random);
                var literalFit:LiteralOrientedBoxFit = new LiteralOrientedBoxFit(cloud, 15);
                var volume:Number = new OrientedBoxFitter(15).fit(cloud).volume;
                assertTrue(volume + " instead of " + literalFit.volume, Math.abs(volume / literalFit.volume - 1) < 1e-6);
            }
        }

        [Test]
        public function boxesAreOrdered():void
        {
            var random:SeededRandom = new SeededRandom(43);
            for (var i:int = 0; i < 20; i++)
            {
                var session:FitSession = new FitSession(PointSets.turned(PointSets.cloud(random, 40, 1, 0.5, 0.2), random));
                var aligned:Number = session.fit(new AxisAlignedBoxFitter()).volume;
                var zAligned:Number = session.fit(new ZAlignedBoxFitter(10)).volume;
                var oriented:Number = session.fit(new OrientedBoxFitter(10)).volume;
                assertTrue(zAligned <= aligned * (1 + 1e-6));
                assertTrue(oriented <= zAligned * (1 + 1e-6));
            }
        }

        [Test]
        public function zAlignedBoxStaysUpright():void
        {
            var random:SeededRandom = new SeededRandom(47);
            var box:Box = Box(new ZAlignedBoxFitter(7).fit(PointSets.turned(PointSets.cloud(random, 40, 1, 0.5, 0.2), random)));
            assertEquals(0, box.axisX.z);
            assertEquals(0, box.axisY.z);
            assertEquals(1, box.axisZ.z);
        }

        [Test]
        public function centredSphereStaysOnTheAxis():void
        {
            var random:SeededRandom = new SeededRandom(53);
            for (var i:int = 0; i < 20; i++)
            {
                var sphere:Sphere = Sphere(new CentredRitterSphereFitter().fit(PointSets.cloud(random, 40, 1, 0.5, 2)));
                assertEquals(0, sphere.center.x);
                assertEquals(0, sphere.center.y);
            }
            // a pole and a ring: the sphere through both is 1.25 wide
            sphere = Sphere(new CentredRitterSphereFitter().fit(PointSets.cylinder(0.5, 1, 16, 2).concat(new <Number>[0, 0, 1.2])));
            assertTrue(sphere.radius + "", sphere.radius < 0.78);
        }

        [Test]
        public function capsuleTouchesItsVertices():void
        {
            var capsule:Capsule = Capsule(new CapsuleFitter(new AxisAlignedBoxFitter()).fit(
                        new <Number>[0, 0, 0, 4, 0, 0, 2, 1, 0, 2, -1, 0]));
            assertEquals(1, capsule.radius);
            assertEquals(2, Vector3D.distance(capsule.start, capsule.end));
        }

        [Test]
        public function degenerateSetsGetDegenerateStructures():void
        {
            var point:Vector.<Number> = new <Number>[1, 2, 3, 1, 2, 3];
            for each (var fitter:Fitter in allFitters())
            {
                if (!(fitter is CentredRitterSphereFitter))
                {
                    assertEquals(getQualifiedClassName(fitter), 0, fitter.fit(point).volume);
                }
            }
            var segment:Box = Box(new OrientedBoxFitter(10).fit(new <Number>[0, 0, 0, 0, 3, 0]));
            assertEquals(0, segment.volume);
            assertEquals(1.5, segment.halfY);
        }

        [Test]
        public function oneSessionComputesABoxOnce():void
        {
            var counting:CountingFitter = new CountingFitter();
            var session:FitSession = new FitSession(PointSets.box(1, 1, 1));
            session.fit(counting);
            session.fit(new CapsuleFitter(counting));
            session.fit(new CylinderFitter(counting));
            assertEquals(1, counting.count);
            new CapsuleFitter(counting).fit(PointSets.box(1, 1, 1));
            assertEquals(2, counting.count);
        }

        [Test]
        public function refusesWhatItCannotUse():void
        {
            for each (var fitter:Fitter in allFitters())
            {
                assertRefused(fitter.fit, null);
                assertRefused(fitter.fit, new Vector.<Number>());
                assertRefused(fitter.fit, new <Number>[1, 2]);
                assertRefused(fitter.fit, new <Number>[1, 2, NaN]);
            }
            for each (var increment:Number in [0, -10, NaN, Infinity])
            {
                assertRefused(makeOriented, increment);
                assertRefused(makeZAligned, increment);
            }
            assertRefused(makeCapsule, null);
            assertRefused(makeCylinder, null);
            assertRefused(makeRitter, "somehow");
            assertRefused(new CapsuleFitter(new NaiveSphereFitter()).fit, PointSets.box(1, 1, 1));
        }

        private static function makeOriented(increment:Number):void
        {
            new OrientedBoxFitter(increment);
        }

        private static function makeZAligned(increment:Number):void
        {
            new ZAlignedBoxFitter(increment);
        }

        private static function makeCapsule(boxFitter:Fitter):void
        {
            new CapsuleFitter(boxFitter);
        }

        private static function makeCylinder(boxFitter:Fitter):void
        {
            new CylinderFitter(boxFitter);
        }

        private static function makeRitter(start:String):void
        {
            new RitterSphereFitter(start);
        }

        private static function assertRefused(call:Function, argument:*):void
        {
            try
            {
                call(argument);
            }
            catch (error:ArgumentError)
            {
                assertTrue(error.message.length > 10);
                return;
            }
            fail("accepted: " + argument);
        }

        private static function assertEncloses(name:String, fitter:Fitter, session:FitSession):void
        {
            assertHoldsAll(name, fitter, session.fit(fitter), session.vertices);
        }

        private static function assertHoldsAll(name:String, fitter:Fitter, structure:BoundingStructure,
                vertices:Vector.<Number>):void
        {
            assertEquals(name + ", " + getQualifiedClassName(fitter), "", FitChecks.outside(structure, vertices));
        }
    }
}

import flash.geom.Matrix3D;
import flash.utils.ByteArray;
import starlogo.bounding.BoundingStructure;
import starlogo.fitting.AxisAlignedBoxFitter;
import starlogo.fitting.FitSession;
import starlogo.fitting.Fitter;
import starlogo.fitting.RotationSearch;
import starlogo.geometry.ConvexHull;

class SingleRotationSearch extends RotationSearch
{
    private var _bytes:ByteArray = new ByteArray();

    public function SingleRotationSearch(hull:ConvexHull)
    {
        super(hull);
    }

    override protected function transform(matrix:Matrix3D, points:Vector.<Number>, out:Vector.<Number>):void
    {
        matrix.rawData = rounded(matrix.rawData, new Vector.<Number>(16));
        matrix.transformVectors(points, out);
        rounded(out, out);
    }

    private function rounded(numbers:Vector.<Number>, out:Vector.<Number>):Vector.<Number>
    {
        _bytes.position = 0;
        var i:int;
        for (i = 0; i < numbers.length; i++)
        {
            _bytes.writeFloat(numbers[i]);
        }
        _bytes.position = 0;
        for (i = 0; i < numbers.length; i++)
        {
            out[i] = _bytes.readFloat();
        }
        return out;
    }
}

class CountingFitter extends Fitter
{
    public var count:int = 0;

    override public function fitTo(session:FitSession):BoundingStructure
    {
        count++;
        return session.fit(new AxisAlignedBoxFitter());
    }
}
