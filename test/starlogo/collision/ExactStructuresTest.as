package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.ShapeHit;
    import starlogo.queries.WalkOptions;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.EveryTriangle;
    import support.FrameByFrame;
    import support.PlainDistance;
    import support.SolidAngles;
    import support.SolidModels;
    import support.TransformedStructure;
    import support.agentAt;

    use namespace engine;

    /**
     * In exact mode an agent that is a structure meets the triangles and the inside of an agent that is a tree: standing, moving, asked, with
     * contacts. Every triangle is measured by the formulas of textbooks. A structure counts as its own triangles with a radius.
     * <code>./antw module-test -Dtest=ExactStructuresTest -Dfull</code> tries 100,000 placements with their contacts, and 20,000 sweeps and motions.
     */
    public class ExactStructuresTest
    {
        private static const KINDS:Array = [Agent.SPHERE, Agent.CAPSULE, Agent.BOX];
        private static const NEAR:Number = 1e-9;

        // the corners of a box's triangles: a bit for each axis
        private static const BOX:Array = [0, 1, 2, 1, 2, 3, 4, 5, 6, 5, 6, 7, 0, 1, 4, 1, 4, 5, 2, 3, 6, 3, 6, 7, 0, 2, 4, 2, 4, 6, 1, 3, 5, 3, 5, 7];

        private static var sGreatLand:GreatLand;
        private static var sModels:Object;
        private static var sShapes:Array;

        private var _random:SeededRandom = new SeededRandom(5101);
        private var _collider:CombinationCollider = new CombinationCollider(sGreatLand);
        private var _queries:AgentQueries = new AgentQueries(_collider);
        private var _wrong:Complaints = new Complaints();
        private var _touches:int = 0;
        private var _insides:int = 0;
        private var _stopped:int = 0;
        private var _tree:Agent;
        private var _other:Agent;
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _own:Vector.<Number>;

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = new GreatLand();
            sGreatLand.loadAllBoundingStructures = true;
            sModels = {};
            sShapes = [];
            for each (var model:Model in SolidModels.all().concat(BuiltInModel.cylinder()))
            {
                sGreatLand.addModel(model);
                sModels[model.name] = model;
                sShapes.push(model.name);
            }
        }

        [Before]
        public function begin():void
        {
            _collider.exact = true;
        }

        [Test(async, timeout="3600000")]
        public function standing():void
        {
            var count:int = Effort.choose(300, 100000);
            FrameByFrame.repeat(this, count, checkStanding, function():void
                {
                    _wrong.assertNone();
                    assertTrue(_touches + " touch, " + _insides + " inside", _touches > count / 5 && _touches < count * 4 / 5 && _insides > 1);
                });
        }

        private function checkStanding(i:int):void
        {
            place(i);
            var structure:BoundingStructure = structureNow();
            var gap:Number = gapOf(structure);
            var isInside:Boolean = gap > 0 && isInTree(structure);
            var expected:Boolean = gap <= 0 || isInside;
            if (Math.abs(gap) < NEAR)
            {
                return;
            }
            _touches += expected ? 1 : 0;
            _insides += isInside ? 1 : 0;
            check("colliding", expected == _collider.areColliding(_tree, _other) && expected == _collider.areColliding(_other, _tree), structure);
            check("in a frame", expected == _collider.findCollisions(new <Agent>[_other, _tree]).length > 0, structure);
            _queries.update(new <Agent>[_tree, _other]);
            var pointA:Vector3D = new Vector3D();
            var pointB:Vector3D = new Vector3D();
            var distance:Number = _queries.distance(_tree, _other, pointA, pointB);
            check("distance " + distance + ", not " + gap, Math.abs(distance - (expected ? 0 : gap)) < NEAR, structure);
            check("points", Math.abs(Vector3D.distance(pointA, pointB) - distance) < NEAR && structure.contains(pointB), structure);
            if (expected && !isInside)
            {
                checkContact(structure);
            }
        }

        // An edge of an agent that lies along an edge of two triangles meets their common plane. Their edge is no edge of the floor.
        [Test]
        public function edgesAlongSeamsMeetThePlaneOfTheFloor():void
        {
            for each (var slope:Number in [0, 0.25, -0.5])
            {
                var land:GreatLand = new GreatLand();
                land.loadHulls = true;
                for each (var model:Model in [BuiltInModel.cube(), SolidModels.keel(), SolidModels.floor(slope)])
                {
                    land.addModel(model);
                }
                for (var i:int = 0; i < 48; i++)
                {
                    var agent:Agent = agentAt(i % 2 == 0 ? "cube" : "keel", i % 3 == 0 ? 0.5 : 0, i % 3 == 1 ? 0.5 : 0, 4, "wolves");
                    agent.roll = i % 2 == 0 ? 45 : 0;
                    agent.heading = [0, 30, 45, 90][int(i / 6) % 4];
                    agent.hierarchical = i >= 24;
                    agent.collideAs = i % 2 == 0 ? "box" : "hull";
                    checkSeam(EachCollider.make("combinations, exact", land), agent, slope, agent + ", slope " + slope + ", case " + i);
                }
            }
        }

        private static function checkSeam(collider:Collider, agent:Agent, slope:Number, what:String):void
        {
            var floor:Agent = agentAt("floor", 0, 0, 0);
            floor.hierarchical = true;
            var up:Vector3D = new Vector3D(0, -slope, 1);
            up.normalize();
            var queries:AgentQueries = new AgentQueries(collider);
            queries.update(new <Agent>[floor, agent]);
            var normal:Vector3D = queries.castAgent(agent, 0, 0, -8).normal;
            assertTrue(what + ": " + normal, normal.dotProduct(up) > 1 - 1e-9);
            var options:WalkOptions = new WalkOptions();
            options.fall = 8;
            floor.isOneWay = true;
            assertTrue(what + " stands", queries.walk(agent, 0, 0, options).stands);

            var collision:Collision = new Collision(collider);
            collision.onCollision("wolves", "turtles", function(wolf:Agent, turtle:Agent, contact:Contact):void
                {
                    normal = contact.normal.clone();
                });
            agent.sweeps = true;
            agent.jumpTo(agent.x, agent.y, 4);
            collision.update(new <Agent>[agent, floor]);
            normal = null;
            agent.moveTo(agent.x, agent.y, -4);
            collision.update(new <Agent>[agent, floor]);
            assertTrue(what + " in a frame: " + normal, normal != null && normal.dotProduct(up) > 1 - 1e-9);
        }

        [Test(async, timeout="3600000")]
        public function moving():void
        {
            var count:int = Effort.choose(70, 20000);
            FrameByFrame.repeat(this, count, checkMoving, function():void
                {
                    _wrong.assertNone();
                    assertTrue(_stopped + " of " + count, _stopped > count / 10 && _stopped < count * 9 / 10);
                });
        }

        private function checkMoving(i:int):void
        {
            var structure:BoundingStructure = null;
            while (structure == null || _collider.areColliding(_tree, _other) || gapOf(structure) < NEAR)
            {
                place(i);
                structure = structureNow();
            }
            _queries.update(new <Agent>[_tree, _other]);
            var way:Vector3D = new Vector3D(_random.between(-2, 2), _random.between(-2, 2), _random.between(-2, 2));
            var hit:ShapeHit = _queries.castAgent(_other, way.x, way.y, way.z);
            var most:Number = hit == null ? 1 : hit.time;
            _stopped += hit == null ? 0 : 1;
            for (var k:int = 0; k <= 20; k++)
            {
                var share:Number = (most - 1e-7) * k / 20;
                check("through", share < 0 || gapOf(moved(structure, way, share)) > 0, structure);
            }
            check("stops early", hit == null || gapOf(moved(structure, way, most)) < 1e-8, structure);
            checkSweep(way, most, hit != null, structure);
            checkCastShape(way, most, hit, structure);
            var x:Number = _other.x;
            check("motion", Math.abs(_queries.moveUntilTouch(_other, way.x, way.y, way.z) - most) < 1e-12, structure);
            check("moved", Math.abs(_other.x - x - most * way.x) < 1e-8, structure);
        }

        // A tree about the origin, and near it an agent that has a structure. Some are small, so that they get inside.
        private function place(i:int):void
        {
            _tree = agent(1.5);
            _tree.hierarchical = true;
            _other = agent(_random.chance(0.4) ? 0.2 : 1);
            _other.collideAs = KINDS[i % 3];
            _other.moveTo(_random.between(-1.3, 1.3), _random.between(-1.3, 1.3), _random.between(-0.8, 1.8));
            EveryTriangle.place(_tree.freshPlacement(), sModels[_tree.shape], _corners);
        }

        private function agent(size:Number):Agent
        {
            var agent:Agent = new Agent(_random.pick(sShapes));
            agent.size = size * _random.logBetween(0.7, 1.4);
            agent.heading = _random.between(0, 360);
            if (_random.chance())
            {
                agent.pitch = _random.between(-90, 90);
                agent.roll = _random.between(-180, 180);
            }
            return agent;
        }

        private function structureNow():BoundingStructure
        {
            return TransformedStructure.of(sGreatLand.boundingStructures.findOrFit(_other.shape, _other.structureKind), _other);
        }

        // The distance of a structure from the tree's triangles. It is 0 or less if it touches one.
        private function gapOf(structure:BoundingStructure):Number
        {
            var radius:Number = 0;
            if (structure is Sphere)
            {
                var center:Vector3D = Sphere(structure).center;
                _own = new <Number>[center.x, center.y, center.z, center.x, center.y, center.z, center.x, center.y, center.z];
                radius = Sphere(structure).radius;
            }
            else if (structure is Capsule)
            {
                var start:Vector3D = Capsule(structure).start;
                var end:Vector3D = Capsule(structure).end;
                _own = new <Number>[start.x, start.y, start.z, end.x, end.y, end.z, end.x, end.y, end.z];
                radius = Capsule(structure).radius;
            }
            else
            {
                _own = trianglesOf(Box(structure));
            }
            var least:Number = Infinity;
            for (var i:int = 0; i < _corners.length; i += 9)
            {
                for (var k:int = 0; k < _own.length; k += 9)
                {
                    least = Math.min(least, PlainDistance.ofTriangles(_own, k, _corners, i));
                }
            }
            // contains() has a tolerance
            for (i = 0; structure is Box && least > 1e-4 && i < _corners.length; i += 9)
            {
                least = structure.contains(new Vector3D(_corners[i], _corners[i + 1], _corners[i + 2])) ? -1 : least;
            }
            return least - radius;
        }

        private static function trianglesOf(box:Box):Vector.<Number>
        {
            var out:Vector.<Number> = new Vector.<Number>();
            for each (var corner:int in BOX)
            {
                var at:Vector3D = box.center;
                at = moved(at, box.axisX, (corner & 1) == 0 ? -box.halfX : box.halfX);
                at = moved(at, box.axisY, (corner & 2) == 0 ? -box.halfY : box.halfY);
                at = moved(at, box.axisZ, (corner & 4) == 0 ? -box.halfZ : box.halfZ);
                out.push(at.x, at.y, at.z);
            }
            return out;
        }

        // Whether the structure that gapOf() has measured last is inside of the tree.
        private function isInTree(structure:BoundingStructure):Boolean
        {
            var model:Model = sModels[_tree.shape];
            var at:Vector3D = structure is Box ? Box(structure).center : new Vector3D(_own[0], _own[1], _own[2]);
            var m:Object = _tree.freshPlacement();
            var x:Number = (at.x - m.x) / m.size;
            var y:Number = (at.y - m.y) / m.size;
            var z:Number = (at.z - m.z) / m.size;
            return SolidAngles.closes(model) && Math.abs(SolidAngles.windingAround(model, m.r00 * x + m.r10 * y + m.r20 * z,
                        m.r01 * x + m.r11 * y + m.r21 * z, m.r02 * x + m.r12 * y + m.r22 * z)) > 0.5;
        }

        // Moved by the depth, the two touch no more; by a little less, they still do.
        private function checkContact(structure:BoundingStructure):void
        {
            var contact:Contact = _collider.contactOf(_other, _tree);
            var depth:Number = contact.depth;
            var normal:Vector3D = contact.normal;
            var at:Vector3D = new Vector3D(_other.x, _other.y, _other.z);
            var extent:Number = 4;
            _other.moveTo(at.x + (depth + NEAR * extent) * normal.x, at.y + (depth + NEAR * extent) * normal.y, at.z + (depth + NEAR * extent) * normal.z);
            check("contact holds", !_collider.areColliding(_tree, _other), structure);
            _other.moveTo(at.x + (depth - NEAR * extent) * normal.x, at.y + (depth - NEAR * extent) * normal.y, at.z + (depth - NEAR * extent) * normal.z);
            check("contact too deep", depth < NEAR * extent || _collider.areColliding(_tree, _other), structure);
            _other.moveTo(at.x, at.y, at.z);
        }

        // The frame's sweep finds the time of the cast.
        private function checkSweep(way:Vector3D, most:Number, isHit:Boolean, structure:BoundingStructure):void
        {
            var collider:CombinationCollider = new CombinationCollider(sGreatLand);
            collider.exact = true;
            var agents:Vector.<Agent> = new <Agent>[_other, _tree];
            _other.sweeps = true;
            var at:Vector3D = new Vector3D(_other.x, _other.y, _other.z);
            collider.findCollisions(agents);
            _other.moveTo(at.x + way.x, at.y + way.y, at.z + way.z);
            var found:int = collider.findCollisions(agents).length;
            check("swept", found > 0 == isHit, structure);
            if (found > 0 && isHit)
            {
                check("swept time", Math.abs(collider.contactOf(_other, _tree).time - most) < 1e-8, structure);
            }
            _other.sweeps = false;
            _other.jumpTo(at.x, at.y, at.z);
        }

        private function checkCastShape(way:Vector3D, most:Number, expected:ShapeHit, structure:BoundingStructure):void
        {
            var filter:AgentFilter = new AgentFilter();
            filter.except = new <Agent>[_other];
            var hit:ShapeHit = _queries.castShape(structure, way.x, way.y, way.z, filter);
            check("castShape", (hit == null) == (expected == null), structure);
            if (hit != null && expected != null)
            {
                check("castShape's time", Math.abs(hit.time - expected.time) < 1e-9, structure);
            }
        }

        private static function moved(what:*, way:Vector3D, share:Number):*
        {
            var by:Vector3D = new Vector3D(share * way.x, share * way.y, share * way.z);
            return what is Vector3D ? Vector3D(what).add(by) : BoundingStructure(what).clone().translate(by);
        }

        private function check(what:String, isRight:Boolean, structure:BoundingStructure):void
        {
            _wrong.addIf(!isRight, what, structure + " and " + _tree.shape + " of size " + _tree.size);
        }
    }
}
