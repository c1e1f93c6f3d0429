package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.RandomWorlds;
    import support.SolidModels;

    /** The contact of two that do not touch: where they are nearest, beside the distance of the questions. */
    public class ApartContactsTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "hollow", "crossed", "apart", "open cube", "doll"];
        private static const NEAR:Number = 1e-9;

        private var _greatLand:GreatLand = new GreatLand();
        private var _random:SeededRandom = new SeededRandom(5512);
        private var _wrong:Complaints = new Complaints();
        private var _apart:int = 0;

        [Before]
        public function begin():void
        {
            for each (var model:Model in SolidModels.all())
            {
                _greatLand.addModel(model);
            }
        }

        [Test]
        public function itIsWhereTheyAreNearest():void
        {
            var terrain:Terrain = new Terrain(9, 9, 1, -4, -4);
            terrain.raiseMound(0, 0, 6, 1);
            terrain.raiseMound(3, 3, 100, -4);
            var bounds:WorldBounds = new WorldBounds(-5, -5, -5, 5, 5, 5);
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var collider:Collider = EachCollider.make(name, _greatLand);
                var queries:AgentQueries = new AgentQueries(collider);
                for (var i:int = Effort.choose(80, 1000); i > 0; i--)
                {
                    var agents:Vector.<Agent> = RandomWorlds.mixed(2, SHAPES, 1.5, _random);
                    check(name, collider, queries, agents[0], agents[1]);
                    check(name + ", ground", collider, queries, agents[0], terrain.agent);
                    check(name + ", edges", collider, queries, agents[1], bounds.agent);
                }
            }
            _wrong.assertNone();
            assertTrue(_apart + " are apart", _apart > 400);
        }

        // Far out the closest points of two that are hardly apart are rounded more than they are apart.
        [Test]
        public function twoThatHardlyPartHaveTheNormalOfTheirTouch():void
        {
            var collider:Collider = new TightestFitCollider(_greatLand);
            var cube:Agent = new Agent("cube");
            var other:Agent = new Agent("cube");
            for each (var kind:String in [Agent.SPHERE, Agent.CAPSULE, Agent.HULL])
            {
                other.collideAs = kind;
                for (var i:int = Effort.choose(20, 500); i > 0; i--)
                {
                    cube.heading = _random.between(0, 360);
                    cube.pitch = _random.between(0, 40);
                    other.roll = _random.between(0, 50);
                    other.moveTo(1e6 + _random.between(0, 0.3), 1e6 + _random.between(0, 0.3), 0);
                    var touching:Number = 0;
                    var free:Number = 3;
                    while (free - touching > 1e-9)
                    {
                        var middle:Number = (touching + free) / 2;
                        cube.moveTo(1e6 + middle, 1e6, 0.01);
                        if (collider.areColliding(cube, other))
                        {
                            touching = middle;
                        }
                        else
                        {
                            free = middle;
                        }
                    }
                    cube.moveTo(1e6 + touching - 1e-5, 1e6, 0.01);
                    var touch:Vector3D = collider.contactOf(cube, other).normal.clone();
                    cube.moveTo(1e6 + free, 1e6, 0.01);
                    var apart:Contact = collider.contactOf(cube, other);
                    _wrong.addIf(!(apart.normal.dotProduct(touch) > 0.9 && apart.depth == 0), kind, apart + ", and touching " + touch);
                }
            }
            _wrong.assertNone();
        }

        // A gap may be a tiny part of the large one, and still have a direction.
        [Test]
        public function aSmallOneBesideTheEdgeOfALargeOneHasTheDirectionBetweenThem():void
        {
            for each (var kind:String in [Agent.BOX, Agent.SPHERE, Agent.CAPSULE, Agent.HULL])
            {
                for each (var sizes:Array in [[1e6, 1, 5e-4], [1e6, 1e-4, 9e-4], [1e6, 1e-4, 1e-5], [100, 1e-4, 5e-8], [1, 1, 5e-10], [1, 1, 1e-11]])
                {
                    checkBesideEdge(kind, sizes[0], sizes[1], sizes[2]);
                }
            }
            _wrong.assertNone();
        }

        private function checkBesideEdge(kind:String, large:Number, small:Number, gap:Number):void
        {
            var collider:Collider = new TightestFitCollider(_greatLand);
            var queries:AgentQueries = new AgentQueries(collider);
            var cube:Agent = new Agent("cube");
            cube.collideAs = Agent.BOX;
            cube.size = large;
            var other:Agent = new Agent("cube");
            other.collideAs = kind;
            other.size = small;
            if (kind == Agent.BOX || kind == Agent.HULL)
            {
                // from edge to edge
                var x:Number = (large + small) / 2;
                other.moveTo(x + 0.6 * gap, x + 0.5 * gap, large / 4);
            }
            else
            {
                moveToGap(queries, cube, other, gap);
            }
            var first:Vector3D = new Vector3D();
            var second:Vector3D = new Vector3D();
            queries.distance(other, cube, first, second);
            var direction:Vector3D = first.subtract(second);
            direction.normalize();
            var contact:Contact = collider.contactOf(other, cube);
            _wrong.addIf(!(contact.normal.dotProduct(direction) > 0.999), kind, contact + ", and " + direction + " between " + cube + " and " + other);
        }

        // Moves an agent on a diagonal beside an edge of a cube, to about this distance.
        private function moveToGap(queries:AgentQueries, cube:Agent, other:Agent, gap:Number):void
        {
            var touching:Number = 0;
            var free:Number = 2 * other.size + gap;
            for (var i:int = 0; i < 60; i++)
            {
                var middle:Number = (touching + free) / 2;
                other.moveTo(cube.size / 2 + middle, cube.size / 2 + 0.8 * middle, cube.size / 4);
                if (queries.distance(cube, other) < gap)
                {
                    touching = middle;
                }
                else
                {
                    free = middle;
                }
            }
            other.moveTo(cube.size / 2 + free, cube.size / 2 + 0.8 * free, cube.size / 4);
        }

        // Two of the three cubes stand at the same height, as legs do. The point between them belongs to nothing.
        [Test]
        public function theNearestPointToAnEdgeIsTheAgentsOwn():void
        {
            var bounds:WorldBounds = new WorldBounds(-5, -5, -5, 5, 5, 5);
            var legs:Agent = new Agent("apart");
            legs.hierarchical = true;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var collider:Collider = EachCollider.make(name, _greatLand);
                var queries:AgentQueries = new AgentQueries(collider);
                for each (var z:Number in [-2, -5, -5.1])
                {
                    for (legs.heading = 0; legs.heading < 90; legs.heading += 15)
                    {
                        legs.moveTo(0.3, 0.2, z);
                        var own:Vector3D = new Vector3D();
                        var other:Vector3D = new Vector3D();
                        var distance:Number = queries.distance(legs, bounds.agent, own, other);
                        var message:String = own + " and " + other + " at " + z + ", heading " + legs.heading;
                        _wrong.addIf(!(queries.distanceToPoint(legs, own) < NEAR), name + ": not of the agent", message);
                        var point:Vector3D = collider.contactOf(legs, bounds.agent).point;
                        var half:Vector3D = new Vector3D((own.x + other.x) / 2, (own.y + other.y) / 2, z > -5 ? (own.z + other.z) / 2 : point.z);
                        _wrong.addIf(!(Vector3D.distance(half, point) < NEAR), name + ": another contact", message + ", " + point);
                        _wrong.addIf(!(Math.abs(Vector3D.distance(own, other) - distance) < NEAR) || z > -5 && Math.abs(other.z + 5) > NEAR, name + ": not of the edge", message);
                    }
                }
            }
            _wrong.assertNone();
        }

        private function check(name:String, collider:Collider, queries:AgentQueries, a:Agent, b:Agent):void
        {
            var first:Vector3D = new Vector3D();
            var second:Vector3D = new Vector3D();
            var distance:Number = queries.distance(a, b, first, second);
            if (distance == 0)
            {
                return;
            }
            _apart++;
            var contact:Contact = collider.contactOf(a, b);
            var message:String = contact + ", " + distance + " from " + first + " to " + second + ": " + a + " and " + b;
            _wrong.addIf(contact.depth != 0, name + ": a depth", message);
            var toFirst:Number = queries.distanceToPoint(a, contact.point);
            var toSecond:Number = queries.distanceToPoint(b, contact.point);
            _wrong.addIf(!(Math.abs(toFirst - distance / 2) < NEAR && Math.abs(toSecond - distance / 2) < NEAR), name + ": not half way, " + toFirst + " and " + toSecond,
                    message);
            var gap:Vector3D = first.subtract(second);
            _wrong.addIf(!(gap.dotProduct(contact.normal) > (1 - NEAR) * distance) && distance > NEAR, name + ": another normal", message);
            var reversed:Contact = collider.contactOf(b, a);
            var isSame:Boolean = reversed.point.equals(contact.point) && reversed.normal.x == -contact.normal.x && reversed.normal.y == -contact.normal.y
                && reversed.normal.z == -contact.normal.z && reversed.depth == 0;
            _wrong.addIf(!isSame, name + ": another in the other order", message);
        }
    }
}
