package starlogo.search.penetration
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.data.textOf;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.Terrain;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.SolidModels;
    import support.ThinModels;
    import support.landOf;

    /**
     * Contacts separate: moved by the depth and a hair more along the normal, the collider does not touch the collidee any more; by a hair less it
     * still does. A hair is 1e-9 of the larger extent. The system's own areColliding() decides, so that nothing is computed as the contact was.
     */
    public class PenetrationSearchTest
    {
        private static const HAIR:Number = 1e-9;
        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "plank", "hollow", "crossed", "apart", "open cube", "doll", "horns"];
        private static const SYSTEMS:Array = EachCollider.NAMES;

        private static var sGreatLand:GreatLand;

        private var _random:SeededRandom = new SeededRandom(2201);
        private var _wrong:Complaints = new Complaints();
        private var _overlapping:int = 0;
        private var _deep:int = 0;

        [BeforeClass]
        public static function makeModels():void
        {
            sGreatLand = landOf(SolidModels.all(), BuiltInModel.cylinder(), ThinModels.make("plane"), SolidModels.plank(),
                    SolidModels.of("horns", [[1, 0, 0, 0, false], [0.3, -0.5, 0, 0.9, false], [0.3, 0.5, 0, 0.9, false],
                            [0.2, -0.5, 0, 1.1, false], [0.2, 0.5, 0, 1.1, false]]));
        }

        [Test]
        public function standing():void
        {
            for each (var name:String in SYSTEMS)
            {
                var collider:Collider = make(name);
                for (var i:int = Effort.choose(300, 10000); i > 0; i--)
                {
                    var a:Agent = anyAgent();
                    var b:Agent = anyAgent();
                    place(a, b, 1, 10);
                    if (collider.areColliding(a, b))
                    {
                        check(name + ", " + pairName(a, b), collider, a, b, collider.contactOf(a, b));
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(_overlapping + " overlap, " + _deep + " deep", _overlapping > 600 && _deep > 500);
        }

        /**
         * The point of a contact is in the middle of the push: once the collider is out, both touch a little ball there, half of the depth on. Trees
         * that touch at several places may have their point between these. A collider that is shorter than the push has its point in
         * its own middle, so only contacts count that are shallower than half of the smaller size.
         */
        [Test]
        public function pointsAreInTheMiddleOfThePush():void
        {
            var ball:Agent = new Agent("sphere");
            for each (var name:String in SYSTEMS)
            {
                var collider:Collider = make(name);
                var deep:int = 0;
                var elsewhere:int = 0;
                for (var i:int = 0; i < 250; i++)
                {
                    var a:Agent = anyAgent();
                    var b:Agent = anyAgent();
                    place(a, b, 1, 10);
                    var contact:Contact = collider.areColliding(a, b) ? collider.contactOf(a, b) : null;
                    var extent:Number = Math.max(a.size, b.size);
                    if (contact == null || contact.depth < 0.05 * extent || contact.depth > 0.5 * Math.min(a.size, b.size))
                    {
                        continue;
                    }
                    deep++;
                    var n:Vector3D = contact.normal;
                    var half:Number = contact.depth / 2;
                    ball.size = 0.04 * extent;
                    ball.moveTo(contact.point.x + half * n.x, contact.point.y + half * n.y, contact.point.z + half * n.z - ball.size / 2);
                    a.moveTo(a.x + contact.depth * n.x, a.y + contact.depth * n.y, a.z + contact.depth * n.z);
                    elsewhere += collider.areColliding(ball, a) && collider.areColliding(ball, b) ? 0 : 1;
                }
                var allowed:Number = name == "bins" || name == "tightest fits" ? 0 : 0.2 * deep;
                assertTrue(name + ": " + elsewhere + " of " + deep + " elsewhere", deep > 20 && elsewhere <= allowed);
            }
        }

        /** Along a part of a long push the two may be free. The point belongs to the push that is left, not to the long one. */
        [Test]
        public function thePointOfAShortPushIsWhereTheTwoTouch():void
        {
            var greatLand:GreatLand = landOf(new Model("triangle", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], new <uint>[0, 1, 2], Model.AS_GIVEN),
                    BuiltInModel.box(0.00001, 1, 2, "sheet"));
            var collider:HierarchicalCollider = new HierarchicalCollider(greatLand);
            collider.exact = true;
            var queries:AgentQueries = new AgentQueries(collider);
            var triangle:Agent = turned("triangle", 30, 80, 300);
            var sheet:Agent = turned("sheet", 270, 10, 330);
            sheet.moveTo(-0.442, 0.081, -0.926);
            expectPointInBoth(collider, queries, triangle, sheet);
            triangle = turned("triangle", 300, 0, 150);
            sheet = turned("sheet", 20, 290, 320);
            sheet.moveTo(-0.164, -0.436, 0.294);
            expectPointInBoth(collider, queries, triangle, sheet);
        }

        private static function expectPointInBoth(collider:Collider, queries:AgentQueries, a:Agent, b:Agent):void
        {
            var contact:Contact = collider.contactOf(a, b);
            for each (var agent:Agent in [a, b])
            {
                var off:Number = queries.distanceToPoint(agent, contact.point);
                assertTrue(agent + ": off by " + off + ", " + contact, off <= contact.depth + 2e-8);
            }
        }

        /** Far from the origin rounding may hide the touch at the end of a way back. */
        [Test]
        public function aContactDoesNotDependOnTheOneBefore():void
        {
            var greatLand:GreatLand = landOf(new Model("two", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], new <uint>[0, 1, 2, 0, 1, 3], Model.AS_GIVEN));
            var collider:HierarchicalCollider = new HierarchicalCollider(greatLand);
            collider.exact = true;
            var a:Agent = turned("two", 30, 90, 180);
            var b:Agent = turned("two", 0, 0, 180);
            a.size = b.size = 1e-6;
            a.moveTo(5e8, 0, 0);
            b.moveTo(5e8, 6e-7, -1e-6);
            var first:String = textOf(collider.contactOf(a, b));
            for each (var pitch:Number in [45, 90, 135])
            {
                var other:Agent = turned("two", 10, pitch, 0);
                other.moveTo(0.1, 0.1, 0.05);
                collider.contactOf(turned("two", 0, 0, 0), other);
                assertEquals("after a pitch of " + pitch, first, textOf(collider.contactOf(a, b)));
            }
        }

        private static function turned(shape:String, heading:Number, pitch:Number, roll:Number):Agent
        {
            var agent:Agent = new Agent(shape);
            agent.heading = heading;
            agent.pitch = pitch;
            agent.roll = roll;
            return agent;
        }

        /** Contacts of two agents are the same to the last bit in either order. */
        [Test]
        public function inEitherOrder():void
        {
            var touching:int = 0;
            for each (var name:String in SYSTEMS)
            {
                var collider:Collider = make(name);
                for (var i:int = 0; i < 100; i++)
                {
                    var a:Agent = anyAgent();
                    var b:Agent = anyAgent();
                    place(a, b, 1, 10);
                    if (!collider.areColliding(a, b))
                    {
                        continue;
                    }
                    touching++;
                    var contact:Contact = collider.contactOf(a, b);
                    var other:Contact = collider.contactOf(b, a);
                    other.normal.negate();
                    _wrong.addIf(textOf(contact) != textOf(other), name, i + ", " + pairName(a, b) + ": " + textOf(contact) + " and " + textOf(other));
                }
            }
            _wrong.assertNone();
            assertTrue(touching + " touch", touching > 200);
        }

        private static function textOf(contact:Contact):String
        {
            return [contact.depth, contact.normal.x + 0, contact.normal.y + 0, contact.normal.z + 0, contact.point].join();
        }

        [Test]
        public function insideOfALargeOne():void
        {
            for each (var name:String in ["triangles", "hierarchies", "combinations"])
            {
                var collider:Collider = make(name);
                for (var i:int = Effort.choose(100, 5000); i > 0; i--)
                {
                    var a:Agent = anyAgent();
                    var b:Agent = anyAgent();
                    a.size = _random.logBetween(1e-4, 0.3) * b.size;
                    place(a, b, 0.5, 1);
                    if (_random.chance())
                    {
                        var c:Agent = a;
                        a = b;
                        b = c;
                    }
                    if (collider.areColliding(a, b))
                    {
                        check(name + ", " + pairName(a, b), collider, a, b, collider.contactOf(a, b));
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(_overlapping + " overlap, " + _deep + " deep", _overlapping > 100 && _deep > 50);
        }

        [Test]
        public function passing():void
        {
            var late:int = 0;
            for each (var name:String in SYSTEMS)
            {
                for (var i:int = Effort.choose(200, 10000); i > 0; i--)
                {
                    var collider:Collider = i % 50 == 0 || collider == null ? make(name) : collider;
                    var a:Agent = anyAgent();
                    var b:Agent = anyAgent();
                    a.sweeps = true;
                    b.sweeps = _random.chance();
                    var agents:Vector.<Agent> = new <Agent>[a, b];
                    place(a, b, _random.chance(0.2) ? 1 : 4, 10);
                    var from:Array = [a.x, a.y, a.z, b.x, b.y, b.z];
                    collider.findCollisions(agents);
                    place(a, b, 1, 10);
                    if (collider.findCollisions(agents).length == 2)
                    {
                        var contact:Contact = collider.contactOf(a, b);
                        late += contact.time > 0 ? 1 : 0;
                        moveBack(a, from, 0, contact.time);
                        moveBack(b, from, 3, contact.time);
                        check(name + ", " + pairName(a, b), collider, a, b, contact);
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(_overlapping + " overlap, " + late + " late", _overlapping > 600 && late > 500);
        }

        // A ball between a floor and a roof that meets it goes out of both at once, along the line between them.
        [Test]
        public function outOfAnAcuteCorner():void
        {
            expectOutOfCorners(1, Effort.choose(20, 500), false);
        }

        // The ball touches a triangle at an edge, and is deeper in the triangle beside it.
        [Test]
        public function outOfAnAcuteCornerOfManyTriangles():void
        {
            expectOutOfCorners(1, Effort.choose(40, 500), true);
            expectOutOfCorners(4, Effort.choose(20, 500), true);
        }

        private function expectOutOfCorners(parts:int, balls:int, isBesideEdges:Boolean):void
        {
            for each (var degrees:Number in [15, 40, 60, 80])
            {
                var angle:Number = degrees * Math.PI / 180;
                var collider:CombinationCollider = new CombinationCollider(landOf(cornerOf(angle, parts), BuiltInModel.sphere()));
                collider.exact = true;
                var corner:Agent = new Agent("corner");
                corner.hierarchical = true;
                corner.size = 100;
                for (var i:int = balls; i > 0; i--)
                {
                    var ball:Agent = new Agent("sphere");
                    ball.size = _random.logBetween(0.01, 4);
                    var overlap:Number = ball.size * _random.logBetween(1e-7, 0.02);
                    var x:Number = (ball.size / 2 - overlap) / Math.tan(angle / 2);
                    // the diagonals of squares are edges
                    ball.moveTo(x, isBesideEdges ? x + _random.between(-0.5, 0.5) * ball.size : _random.between(-20, 20), -overlap);
                    var contact:Contact = collider.contactOf(ball, corner);
                    check("corner", collider, ball, corner, contact);
                    _wrong.addIf(contact.depth > 3 * overlap / Math.sin(angle / 2), "out of " + degrees + " degrees", describe(ball, corner, contact));
                }
            }
            _wrong.assertNone();
        }

        // Opposite walls contradict each other: the ball goes off one of them along the ground, and a little up between the two.
        [Test]
        public function outOfACorridorAsWideAsTheBall():void
        {
            var collider:TightestFitCollider = new TightestFitCollider(landOf(BuiltInModel.sphere()));
            var terrain:Terrain = new Terrain(3, 3);
            terrain.isBlocky = true;
            for (var row:int = 0; row < 3; row++)
            {
                terrain.setHeight(0, row, 0.5);
                terrain.setHeight(2, row, 0.5);
            }
            for (var i:int = Effort.choose(30, 1000); i > 0; i--)
            {
                var ball:Agent = new Agent("sphere");
                var off:Number = _random.logBetween(1e-3, 0.1);
                ball.moveTo(1 - off, 1, 0);
                var contact:Contact = collider.contactOf(ball, terrain.agent);
                check("corridor", collider, ball, terrain.agent, contact);
                _wrong.addIf(contact.depth > 1.1 * off, "longer than along the ground", off + ", " + describe(ball, terrain.agent, contact));
            }
            _wrong.assertNone();
        }

        // Past the end of the walls, the free places between their corners become narrower towards the ball, and end at a place above the floor.
        [Test]
        public function outOfTheEndOfACorridorAsWideAsTheBall():void
        {
            var collider:TightestFitCollider = new TightestFitCollider(landOf(BuiltInModel.sphere()));
            var terrain:Terrain = new Terrain(3, 3);
            terrain.isBlocky = true;
            for (var column:int = 0; column < 3; column++)
            {
                terrain.setHeight(column, 0, 1.1);
                terrain.setHeight(column, 2, 0.7);
            }
            for (var i:int = Effort.choose(30, 1000); i > 0; i--)
            {
                var ball:Agent = new Agent("sphere");
                var low:Number = _random.logBetween(1e-3, 0.1);
                ball.moveTo(-0.5, 1, -low);
                var contact:Contact = collider.contactOf(ball, terrain.agent);
                check("end of a corridor", collider, ball, terrain.agent, contact);
                _wrong.addIf(contact.depth > 1.1 * low, "longer than up", low + ", " + describe(ball, terrain.agent, contact));
            }
            _wrong.assertNone();
        }

        // A floor and a roof that cross, each of so many squares along each side.
        private static function cornerOf(angle:Number, parts:int):Model
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for each (var turn:Number in [0, angle])
            {
                for (var i:int = 0; i <= parts; i++)
                {
                    for (var k:int = 0; k <= parts; k++)
                    {
                        var at:int = corners.length / 3;
                        corners.push((i / parts - 0.5) * Math.cos(turn), k / parts - 0.5, (i / parts - 0.5) * Math.sin(turn));
                        if (i < parts && k < parts)
                        {
                            triangles.push(at, at + 1, at + parts + 2, at, at + parts + 2, at + parts + 1);
                        }
                    }
                }
            }
            return new Model("corner", corners, triangles, Model.AS_GIVEN);
        }

        // The push out of one sheet often leads into another.
        [Test]
        public function noPushOutOfALargeCrossIsTwiceAsLongAsNeeded():void
        {
            var land:GreatLand = new GreatLand();
            for each (var degrees:Number in [15, 40, 80])
            {
                var cross:Model = cornerOf(degrees * Math.PI / 180, 1);
                land.addModel(new Model(String(degrees), cross.vertices, cross.triangles));
            }
            var collider:HierarchicalCollider = new HierarchicalCollider(land);
            for (var rest:int = Effort.choose(200, 3000); rest > 0; )
            {
                var small:Agent = turnedCross(_random.between(0.1, 0.3));
                var large:Agent = turnedCross(1);
                place(small, large, 0.7, 0);
                if (collider.areColliding(small, large))
                {
                    rest--;
                    var contact:Contact = collider.contactOf(small, large);
                    _wrong.addIf(isFreeNearby(collider, small, large, contact.depth / 2), "a push that is too long", describe(small, large, contact));
                }
            }
            _wrong.assertNone();
        }

        private function turnedCross(size:Number):Agent
        {
            var agent:Agent = new Agent(_random.pick(["15", "40", "80"]));
            agent.size = size;
            agent.heading = _random.between(0, 360);
            agent.pitch = _random.between(-80, 80);
            agent.roll = _random.between(0, 360);
            return agent;
        }

        // Whether one agent would be free of another at one of some random places at a distance.
        private function isFreeNearby(collider:Collider, agent:Agent, other:Agent, distance:Number):Boolean
        {
            var at:Vector3D = new Vector3D(agent.x, agent.y, agent.z);
            var isFree:Boolean = false;
            for (var i:int = 0; i < 60 && !isFree; i++)
            {
                var way:Vector3D = new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-1, 1));
                way.normalize();
                agent.moveTo(at.x + distance * way.x, at.y + distance * way.y, at.z + distance * way.z);
                isFree = !collider.areColliding(agent, other);
            }
            agent.moveTo(at.x, at.y, at.z);
            return isFree;
        }

        // Where a sheet meets another on its way, a little back against the normal the two are apart too.
        [Test]
        public function noDepthIsNegative():void
        {
            for each (var name:String in SYSTEMS)
            {
                var collider:Collider = make(name);
                for (var i:int = Effort.choose(150, 5000); i > 0; i--)
                {
                    var a:Agent = new Agent("plane");
                    var b:Agent = new Agent("plane");
                    a.size = _random.logBetween(0.05, 60);
                    b.size = _random.logBetween(0.05, 60);
                    a.hierarchical = b.hierarchical = a.sweeps = b.sweeps = true;
                    a.moveTo(_random.normal(), _random.normal(), 1);
                    collider.findCollisions(new <Agent>[a, b]);
                    a.moveTo(a.x + _random.normal(), a.y, -_random.between(0, 1));
                    b.moveTo(_random.normal(), 0, 0);
                    if (collider.findCollisions(new <Agent>[a, b]).length == 2)
                    {
                        var depth:Number = collider.contactOf(a, b).depth;
                        _overlapping++;
                        _wrong.addIf(!(depth >= 0), name, String(depth));
                    }
                }
            }
            _wrong.assertNone();
            assertTrue(_overlapping + " touch", _overlapping > 200);
        }

        private static function moveBack(agent:Agent, from:Array, at:int, time:Number):void
        {
            agent.moveTo(from[at] + time * (agent.x - from[at]), from[at + 1] + time * (agent.y - from[at + 1]),
                    from[at + 2] + time * (agent.z - from[at + 2]));
        }

        private static function pairName(a:Agent, b:Agent):String
        {
            return a.shape < b.shape ? a.shape + " and " + b.shape : b.shape + " and " + a.shape;
        }

        private function check(name:String, collider:Collider, a:Agent, b:Agent, contact:Contact):void
        {
            var n:Number = contact.normal.length;
            if (Math.abs(n - 1) > 1e-12 || !(contact.depth >= 0) || contact.depth == Infinity)
            {
                _wrong.add(name + " has no unit normal, or no depth", contact.normal + ", " + contact.depth);
                return;
            }
            _wrong.addIf(!isInReach(contact.point, a) || b.breed != Collision.TERRAIN && !isInReach(contact.point, b),
                    name + " has its point outside", contact.point + ", " + describe(a, b, contact));
            _overlapping++;
            var extent:Number = Math.max(a.size, b.size);
            if (contact.depth > 0.01 * extent)
            {
                _deep++;
            }
            var x:Number = a.x;
            var y:Number = a.y;
            var z:Number = a.z;
            var far:Number = contact.depth + HAIR * extent;
            a.moveTo(x + far * contact.normal.x, y + far * contact.normal.y, z + far * contact.normal.z);
            _wrong.addIf(collider.areColliding(a, b), name + " still collide", describe(a, b, contact));
            far = contact.depth - HAIR * extent;
            a.moveTo(x + far * contact.normal.x, y + far * contact.normal.y, z + far * contact.normal.z);
            _wrong.addIf(!collider.areColliding(a, b), name + " are apart before", describe(a, b, contact));
            a.moveTo(x, y, z);
        }

        // No model is farther across than 2.5, and none farther than that from its origin.
        private static function isInReach(point:Vector3D, agent:Agent):Boolean
        {
            return Vector3D.distance(point, new Vector3D(agent.x, agent.y, agent.z)) < 2.6 * agent.size;
        }

        private static function describe(a:Agent, b:Agent, contact:Contact):String
        {
            return "depth " + contact.depth + " along " + contact.normal + " of " + a.shape + " size " + a.size + " at " + a.x + ", " + a.y + ", " + a.z
                + " turned " + a.heading + ", " + a.pitch + ", " + a.roll + " and " + b.shape + " size " + b.size + " at " + b.x + ", " + b.y + ", "
                + b.z + " turned " + b.heading + ", " + b.pitch + ", " + b.roll;
        }

        private function anyAgent():Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES));
            agent.size = _random.chance(0.3) ? 1 : _random.logBetween(0.1, 4);
            agent.hierarchical = _random.chance();
            if (_random.chance(0.7))
            {
                agent.heading = _random.between(0, 360);
            }
            if (_random.chance())
            {
                agent.pitch = _random.between(0, 360);
                agent.roll = _random.between(0, 360);
            }
            if (_random.chance(0.3))
            {
                agent.collideAs = _random.pick(["sphere", "box", "capsule"]);
            }
            agent.traversalDepth = _random.pick([0, 0, 0, 1, 2, 4, 8]);
            return agent;
        }

        private function place(a:Agent, b:Agent, share:Number, far:Number):void
        {
            var reach:Number = share * 0.5 * (a.size + b.size);
            b.moveTo(_random.between(-far, far), _random.between(-far, far), _random.between(-far, far));
            a.moveTo(b.x + _random.between(-reach, reach), b.y + _random.between(-reach, reach), b.z + _random.between(-reach, reach));
        }

        private static function make(name:String):Collider
        {
            return EachCollider.make(name, sGreatLand);
        }
    }
}
