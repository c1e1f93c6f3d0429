package starlogo.fitting
{
    import evaluation.pairs.SeededRandom;
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.scaleAndRotatePoints;
    import starlogo.steps.finish;
    import support.CountingFitter;
    import support.Effort;
    import support.FitChecks;
    import support.PointSets;
    import support.RunningHash;
    import support.assertThrows;
    import support.create;

    use namespace engine;

    public class FitterTest
    {
        private static const BOXES:String = "81c5a98e";

        // Those whose structures keep to the model's origin or to its z axis. All others put theirs anywhere.
        private static function fittersAtTheOrigin():Vector.<Fitter>
        {
            return new <Fitter>[new CentredRitterSphereFitter()];
        }

        private static function thesisFitters():Vector.<Fitter>
        {
            var oriented:Fitter = new OrientedBoxFitter(15);
            return new <Fitter>[new NaiveSphereFitter(), new RitterSphereFitter(),
                    new RitterSphereFitter(RitterSphereFitter.FARTHEST_FROM_FIRST),
                    new AxisAlignedBoxFitter(), new ZAlignedBoxFitter(10), oriented, new CapsuleFitter(oriented),
                    new CapsuleFitter(new AxisAlignedBoxFitter()), new CylinderFitter(oriented)];
        }

        private static function minimalFitters():Vector.<Fitter>
        {
            return new <Fitter>[new MinimalSphereFitter(), new MinimalCapsuleFitter(), new HullFitter()];
        }

        private static function allFitters():Vector.<Fitter>
        {
            return thesisFitters().concat(minimalFitters(), fittersAtTheOrigin());
        }

        [Test]
        public function enclosesEveryVertexOfHardSets():void
        {
            for (var seed:int = 1; seed <= 5; seed++)
            {
                encloseHardSets(seed, thesisFitters().concat(fittersAtTheOrigin()), 1);
            }
        }

        [Test]
        public function minimalFitsEncloseEveryVertexOfHardSets():void
        {
            encloseHardSets(1, minimalFitters(), Effort.choose(8, 1));
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

        // Of regular solids many boxes are equally good, but for rounding: Flash Player's Matrix3D holds single-precision numbers.
        [Test]
        public function equallyGoodBoxesAreChosenAlikeOnEveryMachine():void
        {
            var hash:RunningHash = new RunningHash();
            var random:SeededRandom = new SeededRandom(261);
            for (var i:int = 0; i < 60; i++)
            {
                var points:Vector.<Number> = new Vector.<Number>();
                var sides:int = 3 + i % 6;
                for (var ring:int = random.integer(0, 3); ring >= 0; ring--)
                {
                    var radius:Number = random.between(0.2, 1);
                    for (var side:int = 0; side < sides; side++)
                    {
                        points.push(radius * Trigonometry.cosine(360 * side / sides), radius * Trigonometry.sine(360 * side / sides), ring);
                    }
                }
                points.push(0, 0, -0.4);
                var box:Box = Box(new OrientedBoxFitter(10).fit(points));
                for each (var number:Number in [box.axisX.x, box.axisX.y, box.axisX.z, box.axisY.x, box.axisY.y, box.axisY.z, box.volume])
                {
                    hash.addNumber(number);
                }
            }
            assertEquals(BOXES, hash.toString());
        }

        // The vertices along the sides of a flat ribbon are corners of its hull, with sides between them that are in line up to rounding.
        [Test]
        public function ribbonsGetNoLargerBoxThanTheAxisAlignedOne():void
        {
            var random:SeededRandom = new SeededRandom(1034);
            for (var i:int = 0; i < 400; i++)
            {
                var points:Vector.<Number> = new Vector.<Number>();
                var width:Number = Math.pow(10, -1 - i % 3);
                var lean:Number = random.between(0, 90);
                for (var count:int = 2 * random.integer(3, 20), k:int = 0; k < count; k++)
                {
                    var z:Number = k % 2 * 0.5;
                    points.push(width * Trigonometry.cosine(360 * k / count), -z * Trigonometry.sine(lean), z * Trigonometry.cosine(lean));
                }
                points = PointSets.noisy(points, random, 1e-16);
                var box:Number = new OrientedBoxFitter(10).fit(points).volume;
                var least:Number = Math.min(new AxisAlignedBoxFitter().fit(points).volume, new ZAlignedBoxFitter(10).fit(points).volume);
                assertTrue("ribbon " + i + " of width " + width + ": " + box + ", at least " + least, box <= least * (1 + 1e-6) + 1e-14);
            }
        }

        // The boxes around flat models have no volume. The best one is then that of the smallest area, and around a segment the shortest.
        [Test]
        public function flatModelsGetTheSmallestBoxOfAllAngles():void
        {
            var random:SeededRandom = new SeededRandom(271);
            var flat:int = 0;
            for (var i:int = 0; i < 60; i++)
            {
                // rectangles and polygons, segments, points; along the axes, turned by tried angles, turned by any
                var isSegment:Boolean = i % 3 == 1;
                var points:Vector.<Number> = i % 3 == 0 ? PointSets.box(2, 0.1, 0) : PointSets.cloud(random, 6, 2, isSegment ? 0 : 0.5, 0);
                var rotation:Placement = new Placement();
                rotation.setRotation(10 * random.integer(0, 35), i % 5 == 0 ? 0 : 30 * random.integer(0, 11), i % 5 < 2 ? 0 : 30 * random.integer(0, 11));
                points = i % 5 == 4 ? PointSets.turned(points, random) : turned(points, rotation);
                var oriented:OrientedBoxFitter = new OrientedBoxFitter(10);
                var upright:ZAlignedBoxFitter = new ZAlignedBoxFitter(10);
                var extent:Number = new FitSession(points).hull.extent;
                for each (var fitter:Fitter in [oriented, upright])
                {
                    var box:Box = Box(fitter.fit(points));
                    var least:Number = leastOfAllAngles(points, fitter == upright ? 90 : 10, 10, extent);
                    assertTrue(i + ": " + box + ", " + sizeOf(box, extent) + " for " + least, sizeOf(box, extent) <= least * (1 + 1e-6));
                    flat += box.volume == 0 ? 1 : 0;
                    // along the longest side of the box
                    var half:Number = Math.max(box.halfX, box.halfY, box.halfZ);
                    var across:Number = Math.sqrt(box.halfX * box.halfX + box.halfY * box.halfY + box.halfZ * box.halfZ - half * half);
                    var capsule:Capsule = Capsule(new CapsuleFitter(fitter).fit(points));
                    var cylinder:Cylinder = Cylinder(new CylinderFitter(fitter).fit(points));
                    assertTrue(i + ": " + capsule, capsule.radius <= across * (1 + 1e-9) + 1e-12 * extent);
                    assertTrue(i + ": " + cylinder, cylinder.radius <= across * (1 + 1e-9) + 1e-12 * extent);
                }
            }
            assertTrue(flat + " without a volume", flat > 20);
            var point:Vector.<Number> = new <Number>[3, 4, 5];
            assertEquals(0, Box(oriented.fit(point)).volume);
            assertEquals(0, Capsule(new CapsuleFitter(oriented).fit(point)).radius);
        }

        private static function turned(points:Vector.<Number>, rotation:Placement):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>(points.length);
            scaleAndRotatePoints(rotation, points, result);
            return result;
        }

        // The smallest size of a box by a plain search.
        private static function leastOfAllAngles(points:Vector.<Number>, stepXY:Number, stepZ:Number, extent:Number):Number
        {
            var least:Number = Infinity;
            var axes:Vector.<Number> = new Vector.<Number>(9);
            var rotation:Placement = new Placement();
            for (var x:Number = 0; x < 90; x += stepXY)
            {
                for (var y:Number = 0; y < 90; y += stepXY)
                {
                    for (var z:Number = 0; z < 90; z += stepZ)
                    {
                        rotation.setRotation(z, y, x);
                        rotation.readRows(axes, 0);
                        least = Math.min(least, sizeOf(EnclosingStructures.box(points, axes), extent));
                    }
                }
            }
            return least;
        }

        // The volume, in which a side without length counts as a very short one.
        private static function sizeOf(box:Box, extent:Number):Number
        {
            var short:Number = 1e-12 * extent;
            return Math.max(box.halfX, short) * Math.max(box.halfY, short) * Math.max(box.halfZ, short);
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

        /** The first vertex and the one farthest from it are two poles here, and all others are nearer to the middle: so the sphere is exactly theirs. */
        [Test]
        public function ritterSphereBeginsWithTheVertexFarthestFromTheFirst():void
        {
            var random:SeededRandom = new SeededRandom(59);
            for (var i:int = 0; i < 20; i++)
            {
                var pole:Vector.<Number> = PointSets.shell(random, 1, 1);
                var points:Vector.<Number> = pole.concat(PointSets.shell(random, 30, 0.95), new <Number>[-pole[0], -pole[1], -pole[2]]);
                var fitter:Fitter = new RitterSphereFitter(RitterSphereFitter.FARTHEST_FROM_FIRST);
                assertEquals(1, Math.round(Sphere(fitter.fit(points)).radius * 1e9) / 1e9);
            }
        }

        [Test]
        public function degenerateSetsGetDegenerateStructures():void
        {
            for each (var fitter:Fitter in thesisFitters().concat(minimalFitters()))
            {
                assertEquals(getQualifiedClassName(fitter), 0, fitter.fit(new <Number>[1, 2, 3, 1, 2, 3]).volume);
            }
            for each (fitter in allFitters())
            {
                assertEquals(getQualifiedClassName(fitter), 0, fitter.fit(new <Number>[0, 0, 3, 0, 0, 3]).volume);
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
            session.structureOf(counting);
            session.structureOf(new CapsuleFitter(counting));
            session.structureOf(new CylinderFitter(counting));
            assertEquals(1, counting.count);
            new CapsuleFitter(counting).fit(PointSets.box(1, 1, 1));
            assertEquals(2, counting.count);
        }

        [Test]
        public function fittersOfOneSignatureShareAFit():void
        {
            var session:FitSession = new FitSession(PointSets.box(1, 2, 3));
            assertTrue(session.fitOf(new MinimalSphereFitter()) === session.fitOf(new MinimalSphereFitter()));
            assertFalse(session.fitOf(new OrientedBoxFitter(10)) === session.fitOf(new OrientedBoxFitter(15)));
            var counting:CountingFitter = new CountingFitter();
            session.structureOf(counting);
            session.structureOf(new CapsuleFitter(new CountingFitter()));
            assertEquals(1, counting.count);
            // a cylinder has no signature, and an empty one is none
            assertFalse(session.fitOf(new Fitter("")) === session.fitOf(new Fitter("")));
            assertNull(new CapsuleFitter(new Fitter("")).signature);
            assertFalse(session.fitOf(new CylinderFitter(counting)) === session.fitOf(new CylinderFitter(counting)));
        }

        // What a box's setting becomes while the box is found does not count for the capsule either.
        [Test]
        public function aCapsuleKeepsTheBoxThatItBeganWith():void
        {
            var random:SeededRandom = new SeededRandom(59);
            var points:Vector.<Number> = PointSets.turned(PointSets.cloud(random, 40, 1, 0.5, 0.2), random);
            var oriented:OrientedBoxFitter = new OrientedBoxFitter(10);
            var expected:Number = new CapsuleFitter(oriented).fit(points).volume;
            var work:Fit = new CapsuleFitter(oriented).fitting(new FitSession(points));
            oriented.degIncrement = 90;
            finish(work);
            assertEquals(expected, work.structure.volume);
            assertTrue(new CapsuleFitter(oriented).fit(points).volume != expected);
        }

        // Whoever comes first, and however far the other has got.
        [Test]
        public function twoThatNeedTheSameFitShareIt():void
        {
            for (var ahead:int = 0; ahead < 4; ahead++)
            {
                var counting:CountingFitter = new CountingFitter();
                var session:FitSession = new FitSession(PointSets.box(1, 1, 1));
                var capsule:Fit = new CapsuleFitter(counting).fitting(session);
                var box:Fit = session.fitOf(counting);
                assertEquals(0, counting.count);
                for (var i:int = 0; i < ahead; i++)
                {
                    capsule.step();
                }
                finish(box);
                finish(capsule);
                assertEquals(ahead + " steps ahead", 1, counting.count);
                assertTrue(session.structureOf(counting) === box.structure && box.structure is Box);
                assertTrue(capsule.structure is Capsule);
            }
        }

        [Test]
        public function whatHasToBeDoneFirstIsDoneInSteps():void
        {
            var before:CountedSteps = new CountedSteps(3);
            var cube:Vector.<Number> = PointSets.box(1, 1, 1);
            var session:FitSession = new FitSession(cube);
            finish(session);
            var fit:Fit = new Fit(session, before.boxOfThem, before);
            for (var i:int = 0; i < 4; i++)
            {
                assertTrue(fit.step());
                assertEquals(null, fit.structure);
            }
            assertFalse(fit.step());
            assertEquals(3, Box(fit.structure).halfX);
            assertFalse("done", fit.step());
            assertEquals(3, before.done);
        }

        // Thirteen times 90 / 13, added up, is a little less than 90.
        [Test]
        public function rotationsAreMultiplesOfTheIncrement():void
        {
            var points:Vector.<Number> = PointSets.cloud(new SeededRandom(61), 40, 1, 0.5, 0.2);
            assertEquals(13 * 13 - 1, countSteps(new OrientedBoxFitter(90 / 13), points) - countSteps(new OrientedBoxFitter(90), points));
        }

        private static function countSteps(fitter:Fitter, points:Vector.<Number>):int
        {
            var fit:Fit = fitter.fitting(new FitSession(points));
            var count:int = 1;
            while (fit.step())
            {
                count++;
            }
            return count;
        }

        [Test]
        public function minimalCapsulesAreFoundInManySteps():void
        {
            var session:FitSession = new FitSession(PointSets.cloud(new SeededRandom(60), 40, 1, 0.5, 0.2));
            var fit:Fit = new MinimalCapsuleFitter().fitting(session);
            var count:int = 1;
            while (fit.step())
            {
                assertEquals(null, fit.structure);
                count++;
            }
            assertTrue(count + " steps", count > 100 && count < 500);
            assertTrue(fit.structure is Capsule);
        }

        /** The ball through all three has hardly a larger radius than that through two, and its centre is elsewhere. */
        [Test]
        public function theSmallestSphereIsNoLargerThanANaiveOne():void
        {
            var points:Vector.<Number> = new <Number>[0, 2, 2, 0.0003, 2, 3, 0, 1, 3];
            var smallest:Sphere = Sphere(new MinimalSphereFitter().fit(points));
            var naive:Sphere = Sphere(new NaiveSphereFitter().fit(points));
            assertTrue(smallest + ", " + naive, smallest.radius <= naive.radius * (1 + 1e-12));
        }

        [Test]
        public function settingsCountAsTheyWereAtTheBeginning():void
        {
            var random:SeededRandom = new SeededRandom(59);
            var points:Vector.<Number> = PointSets.turned(PointSets.cloud(random, 40, 1, 0.5, 0.2), random);
            for each (var fitter:* in [new OrientedBoxFitter(10), new ZAlignedBoxFitter(10)])
            {
                var expected:Number = fitter.fit(points).volume;
                var session:FitSession = new FitSession(points);
                var work:Fit = fitter.fitting(session);
                fitter.degIncrement = 90;
                finish(work);
                assertEquals(expected, work.structure.volume);
                assertTrue(fitter.fit(points).volume > expected);
            }
        }

        [Test]
        public function refusesWhatItCannotUse():void
        {
            for each (var fitter:Fitter in allFitters())
            {
                assertThrows(ArgumentError, /.{10}/, fitter.fit, null);
                assertThrows(ArgumentError, /.{10}/, fitter.fit, new Vector.<Number>());
                assertThrows(ArgumentError, /.{10}/, fitter.fit, new <Number>[1, 2]);
                assertThrows(ArgumentError, /.{10}/, fitter.fit, new <Number>[1, 2, NaN]);
            }
            for each (var vertices:Vector.<Number> in [null, new Vector.<Number>(), new <Number>[1, 2], new <Number>[1, 2, NaN]])
            {
                assertThrows(ArgumentError, /./, finish, new FitSession(vertices));
                assertThrows(ArgumentError, /./, finish, new NaiveSphereFitter().fitting(new FitSession(vertices)));
            }
            assertThrows(IllegalOperationError, /fitting/, new Fitter().fit, PointSets.box(1, 1, 1));
            assertThrows(RangeError, "1e-70", new NaiveSphereFitter().fit, new <Number>[0, 0, 0, 7e-80, 0, 0]);
            assertThrows(RangeError, "1e-70", new CentredRitterSphereFitter().fit, new <Number>[7e-80, 0, 0]);
            for each (var increment:Number in [0, -10, NaN, Infinity, 0.009, 90 / 4294967296])
            {
                assertThrows(ArgumentError, /.{10}/, create, OrientedBoxFitter, increment);
                assertThrows(ArgumentError, /.{10}/, create, ZAlignedBoxFitter, increment);
            }
            assertThrows(ArgumentError, /.{10}/, create, CapsuleFitter, null);
            assertThrows(ArgumentError, /.{10}/, create, CylinderFitter, null);
            assertThrows(ArgumentError, /.{10}/, create, RitterSphereFitter, "somehow");
            assertThrows(ArgumentError, /.{10}/, new CapsuleFitter(new NaiveSphereFitter()).fit, PointSets.box(1, 1, 1));
        }

        private static function assertEncloses(name:String, fitter:Fitter, session:FitSession):void
        {
            assertEquals(name + ", " + getQualifiedClassName(fitter), "", FitChecks.outside(session.structureOf(fitter), session.vertices));
        }
    }
}

import flash.geom.Vector3D;
import starlogo.bounding.BoundingStructure;
import starlogo.bounding.Box;
import starlogo.fitting.FitSession;
import starlogo.steps.Steps;

class CountedSteps implements Steps
{
    public var done:int = 0;
    private var _count:int;

    public function CountedSteps(count:int)
    {
        _count = count;
    }

    public function step():Boolean
    {
        done++;
        return done < _count;
    }

    public function boxOfThem(session:FitSession):BoundingStructure
    {
        return new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, done, done, done);
    }
}
