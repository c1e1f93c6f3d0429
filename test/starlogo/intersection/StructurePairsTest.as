package starlogo.intersection
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.asserts.fail;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import support.assertClose;
    import support.Complaints;

    /** A pair that has no test says so, and leaves the results as they were. */
    public class StructurePairsTest
    {
        private static const OLD:Number = 0.25;

        private var _collided:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Sphere(new Vector3D(), 1),
                new Capsule(new Vector3D(), new Vector3D(1, 0, 0), 1),
                new Box(new Vector3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), 1, 1, 1),
                new Hull(new <Number>[-1, -1, -1, 1, -1, -1, 0, 1, -1, 0, 0, 1])];

        private var _others:Vector.<BoundingStructure> = new <BoundingStructure>[
                new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 1),
                new BoundingStructure(BoundingStructure.OTHER),
                new BoundingStructure(BoundingStructure.OTHER + 3)];

        private var _motion:RelativeMotion = new RelativeMotion(OLD);
        private var _contact:ContactPoint = new ContactPoint();
        private var _closest:ClosestPoints = new ClosestPoints();

        [Before]
        public function moveTowardsEachOther():void
        {
            _motion.x = 1;
            _contact.depth = _closest.distance = OLD;
        }

        [Test]
        public function tests():void
        {
            eachMissing(function(a:BoundingStructure, b:BoundingStructure):void
                {
                    intersects(a, b);
                });
        }

        [Test]
        public function timesOfImpact():void
        {
            eachMissing(function(a:BoundingStructure, b:BoundingStructure):void
                {
                    StructurePairs.findTimeOfImpact(a, b, _motion);
                });
            assertEquals(OLD, _motion.time);
        }

        [Test]
        public function contacts():void
        {
            eachMissing(function(a:BoundingStructure, b:BoundingStructure):void
                {
                    StructurePairs.findContact(a, b, RelativeMotion.NONE, _contact);
                });
            assertEquals(OLD, _contact.depth);
        }

        [Test]
        public function distances():void
        {
            eachMissing(function(a:BoundingStructure, b:BoundingStructure):void
                {
                    StructurePairs.findClosest(a, b, _closest);
                });
            assertEquals(OLD, _closest.distance);
        }

        [Test]
        public function everyPairOfCollidedKindsHasAll():void
        {
            for each (var a:BoundingStructure in _collided)
            {
                for each (var b:BoundingStructure in _collided)
                {
                    _motion.time = _contact.depth = _closest.distance = OLD;
                    StructurePairs.findTimeOfImpact(a, b, _motion);
                    StructurePairs.findContact(a, b, RelativeMotion.NONE, _contact);
                    StructurePairs.findClosest(a, b, _closest);
                    assertEquals(a + " and " + b + " touch", true, StructurePairs.areTouching(a, b));
                    assertEquals(a + " and " + b + " touch at once", 0, _motion.time);
                    assertEquals(a + " and " + b + " have no distance", 0, _closest.distance);
                    assertEquals(a + " and " + b + " overlap", true, _contact.depth > OLD);
                }
            }
        }

        [Test]
        public function structuresApartDoNotTouch():void
        {
            var far:Placement = new Placement();
            far.x = 4;
            for each (var a:BoundingStructure in _collided)
            {
                for each (var b:BoundingStructure in _collided)
                {
                    var placed:BoundingStructure = b.place(far);
                    assertEquals(a + " and " + placed, false, intersects(a, placed));
                }
            }
        }

        [Test]
        public function noTimeIsAfterTheLatest():void
        {
            var far:Placement = new Placement();
            far.x = 8;
            _motion.x = 10;
            for each (var a:BoundingStructure in _collided)
            {
                for each (var b:BoundingStructure in _collided)
                {
                    var placed:BoundingStructure = b.place(far);
                    var what:String = a + " and " + placed;
                    _motion.latestTime = 1;
                    StructurePairs.findTimeOfImpact(a, placed, _motion);
                    var time:Number = _motion.time;
                    assertEquals(what + " touch: " + time, true, time > 0.4 && time < 0.8);
                    _motion.latestTime = time - 1e-6;
                    StructurePairs.findTimeOfImpact(a, placed, _motion);
                    assertEquals(what + " before they touch", RelativeMotion.NEVER, _motion.time);
                    _motion.latestTime = time + 1e-6;
                    StructurePairs.findTimeOfImpact(a, placed, _motion);
                    assertClose(time, _motion.time, 1e-12, what);
                }
            }
        }

        // The motion ends where the closest points of two structures meet.
        [Test]
        public function aTouchAtTheEndOfAMotionIsFound():void
        {
            var random:SeededRandom = new SeededRandom(7302);
            var structures:RandomStructures = new RandomStructures(random);
            var complaints:Complaints = new Complaints();
            var placement:Placement = new Placement();
            var touching:int = 0;
            for (var i:int = 0; i < 200; i++)
            {
                for each (var a:BoundingStructure in _collided)
                {
                    for each (var b:BoundingStructure in _collided)
                    {
                        placement.setRotation(random.between(0, 360), random.between(0, 360), random.between(0, 360));
                        var place:Vector3D = structures.direction();
                        placement.x = 5 * place.x;
                        placement.y = 5 * place.y;
                        placement.z = 5 * place.z;
                        var placed:BoundingStructure = b.place(placement);
                        StructurePairs.findClosest(a, placed, _closest);
                        placed.translate(_closest.a.subtract(_closest.b));
                        var from:Vector3D = structures.direction();
                        var side:int = from.dotProduct(_closest.b.subtract(_closest.a)) < 0 ? 4 : -4;
                        _motion.endAfter(side * from.x, side * from.y, side * from.z);
                        if (intersects(a, placed))
                        {
                            StructurePairs.findTimeOfImpact(a, placed, _motion);
                            complaints.addIf(_motion.time == RelativeMotion.NEVER, a.kind + " and " + b.kind, a + " and " + placed);
                            touching++;
                        }
                    }
                }
            }
            complaints.assertNone();
            assertTrue(touching + " touch", touching > 3000);
        }

        private function eachMissing(ask:Function):void
        {
            for each (var other:BoundingStructure in _others)
            {
                for each (var structure:BoundingStructure in _collided.concat(_others))
                {
                    refuse(ask, other, structure);
                    refuse(ask, structure, other);
                }
            }
        }

        private static function refuse(ask:Function, a:BoundingStructure, b:BoundingStructure):void
        {
            try
            {
                ask(a, b);
            }
            catch (error:ArgumentError)
            {
                assertEquals(error.message, true, error.message.indexOf(String(a)) >= 0 && error.message.indexOf(String(b)) >= 0);
                return;
            }
            fail("no error for " + a + " and " + b);
        }
    }
}
